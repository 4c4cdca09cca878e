(() => {
  const width = document.documentElement.clientWidth, found = [];
  const say = (what, node) => found.push(what + ": <" + node.tagName + " class=" + (node.getAttribute("class") || "") + "> "
    + node.textContent.trim().slice(0, 60));
  if (document.documentElement.scrollWidth > width) found.push("the page is " + document.documentElement.scrollWidth + " wide");
  const scrolls = node => {
    for (let at = node.parentElement; at && at !== document.body; at = at.parentElement)
      if (getComputedStyle(at).overflowX !== "visible") return true;
    return false;
  };
  for (const node of document.body.querySelectorAll("*")) {
    if (node.closest("svg") && node.tagName !== "svg") continue;
    const box = node.getBoundingClientRect();
    if (box.width && (box.right > width + 1 || box.left < -1) && !scrolls(node)) say("beyond the window", node);
  }
  // what scrolls sideways says so
  for (const node of document.querySelectorAll(".scroll")) {
    if (!node.clientWidth || node.scrollWidth <= node.clientWidth + 1) continue;
    let note = node.previousElementSibling;
    if (note && note.className === "tools") note = note.previousElementSibling;
    if (!note || !note.classList.contains("sideways") || !note.clientHeight || !note.textContent) say("scrolls without a cue", node);
  }
  // letters of a picture stay inside it, and apart from each other
  for (const picture of document.querySelectorAll("svg")) {
    const frame = picture.viewBox.baseVal, drawn = picture.getBoundingClientRect(), boxes = [];
    const unit = frame.width / drawn.width;
    if (!drawn.width) continue;
    // names of limits cover no mark
    const marks = picture.querySelector(".limit") ? [...picture.querySelectorAll("circle, path:not([fill=none]), rect")] : [];
    const seenMarks = marks.map(mark => mark.getBoundingClientRect());
    for (const letters of picture.querySelectorAll("text")) {
      if (letters.textContent.includes("_m")) {
        const box = letters.getBoundingClientRect();
        if (seenMarks.some(m => m.left < box.right && box.left < m.right && m.top < box.bottom && box.top < m.bottom)) say("over a mark", letters);
      }
      const box = letters.getBoundingClientRect();
      // those of the scale that is not chosen
      if (!box.width) continue;
      const [x, y] = [(box.left - drawn.left) * unit, (box.top - drawn.top) * unit];
      const seen = { left: x, right: x + box.width * unit, top: y, bottom: y + box.height * unit, node: letters };
      if (seen.left < -1 || seen.right > frame.width + 1 || seen.top < -2 || seen.bottom > frame.height + 2) say("outside its picture", letters);
      for (const other of boxes)
        if (seen.left < other.right - 1 && other.left < seen.right - 1 && seen.top < other.bottom - 4 && other.top < seen.bottom - 4)
          say("over `" + other.node.textContent + "`", letters);
      boxes.push(seen);
    }
  }
  return found;
})()
