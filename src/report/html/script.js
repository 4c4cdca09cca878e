// Marks answer to pointer, finger and keyboard. Without this script their titles do, and the tables hold the numbers.
(function () {
  "use strict";
  var tip = document.createElement("div"), chosen = null, byKey = false;
  tip.id = "tip";
  tip.setAttribute("role", "status");
  tip.hidden = true;
  document.body.appendChild(tip);

  // a mark's text is its title; moved aside, so that the browser's own tip does not lie over this one
  function text(mark) {
    var title = mark.querySelector("title");
    if (title) {
      mark.setAttribute("aria-label", title.textContent);
      title.remove();
    }
    return mark.getAttribute("aria-label");
  }
  function markOf(node) {
    var mark = node instanceof Element ? node.closest("svg circle, svg polygon, svg rect") : null;
    return mark && (mark.querySelector("title") || mark.hasAttribute("aria-label")) ? mark : null;
  }
  function hide() {
    if (chosen) chosen.classList.remove("chosen");
    chosen = null;
    tip.hidden = true;
  }
  function show(mark, key) {
    hide();
    if (!mark) return;
    chosen = mark;
    byKey = key;
    mark.classList.add("chosen");
    tip.textContent = text(mark);
    tip.hidden = false;
    place();
  }
  function place() {
    var at = chosen.getBoundingClientRect(), room = document.documentElement.clientWidth - tip.offsetWidth - 8;
    var above = at.top - tip.offsetHeight - 8;
    tip.style.left = Math.max(8, Math.min(room, at.left + at.width / 2 - tip.offsetWidth / 2)) + "px";
    tip.style.top = (above > 8 ? above : at.bottom + 8) + "px";
  }
  function marks(picture) {
    return Array.from(picture.querySelectorAll("circle, polygon, rect")).filter(markOf);
  }

  document.addEventListener("pointerover", function (event) { show(markOf(event.target), false); });
  document.addEventListener("scroll", function () { if (chosen && byKey) place(); else hide(); }, true);
  document.querySelectorAll("svg").forEach(function (picture) {
    if (!marks(picture).length) return;
    var at = -1;
    picture.setAttribute("tabindex", "0");
    picture.addEventListener("blur", hide);
    picture.addEventListener("keydown", function (event) {
      var step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
      if (event.key === "Escape") hide();
      if (!step) return;
      event.preventDefault();
      var all = marks(picture);
      at = at < 0 && step < 0 ? all.length - 1 : (at + step + all.length) % all.length;
      all[at].scrollIntoView({ block: "nearest", inline: "nearest" });
      show(all[at], true);
    });
  });
})();
