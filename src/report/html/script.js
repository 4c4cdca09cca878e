// Marks answer to pointer, finger and keyboard. Without this script their titles do, and the tables hold the numbers.
(function () {
  "use strict";
  var texts = document.getElementById("texts");
  texts = texts ? texts.content.textContent.split("\n") : [];
  var words = (document.body.dataset.words || "").split("|");
  var tip = document.createElement("div"), chosen = null, byKey = false;
  tip.id = "tip";
  tip.setAttribute("role", "status");
  tip.hidden = true;
  document.body.appendChild(tip);

  // a mark's text is its title; moved aside, so that the browser's own tip does not lie over this one
  function text(mark) {
    var title = mark.querySelector("title");
    if (title) {
      mark.dataset.text = title.textContent;
      title.remove();
    }
    return mark.dataset.text || texts[mark.dataset.i];
  }
  function markOf(node) {
    var mark = node instanceof Element ? node.closest("svg circle, svg path, svg rect") : null;
    return mark && (mark.dataset.i || mark.dataset.text || mark.querySelector("title")) ? mark : null;
  }
  // the marks of one pose in all pictures: texts of a pose begin with its name
  var poses = null, pinned = null, down = [0, 0];
  function poseOf(mark) {
    var name = mark && /^pose ([^,:]+)/i.exec(text(mark));
    return name ? name[1].trim() : null;
  }
  function link(pose) {
    document.querySelectorAll(".linked").forEach(function (mark) { mark.classList.remove("linked"); });
    if (pose === null) return;
    if (!poses) {
      poses = new Map();
      document.querySelectorAll("svg").forEach(function (picture) {
        marks(picture).forEach(function (mark) {
          var of = poseOf(mark);
          if (of !== null) poses.set(of, (poses.get(of) || []).concat(mark));
        });
      });
    }
    (poses.get(pose) || []).forEach(function (mark) { mark.classList.add("linked"); });
  }
  function pin(mark) {
    var pose = poseOf(mark);
    pinned = pose === pinned ? null : pose;
    link(pinned);
  }
  document.addEventListener("pointerdown", function (event) { down = [event.clientX, event.clientY]; }, true);
  document.addEventListener("click", function (event) {
    // a picture that turns holds the pointer: what lies below it
    var at = event.detail ? document.elementFromPoint(event.clientX, event.clientY) : event.target;
    var turned = event.detail && Math.hypot(event.clientX - down[0], event.clientY - down[1]) > 4;
    if (at instanceof Element && at.closest("svg") && !turned) pin(markOf(at));
  });

  function hide() {
    if (chosen) {
      chosen.classList.remove("chosen");
      link(pinned);
    }
    chosen = null;
    tip.hidden = true;
  }
  function show(mark, key) {
    hide();
    if (!mark) return;
    chosen = mark;
    byKey = key;
    mark.classList.add("chosen");
    link(poseOf(mark) || pinned);
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
    return Array.from(picture.querySelectorAll("circle, path, rect")).filter(markOf);
  }

  document.addEventListener("pointerover", function (event) { show(markOf(event.target), false); });
  document.addEventListener("scroll", function (event) {
    // the contents scroll by themselves
    if (event.target.nodeName === "NAV") return;
    if (chosen && byKey) place(); else hide();
  }, true);
  document.querySelectorAll("svg").forEach(function (picture) {
    if (!picture.querySelector("[data-i], circle > title, path > title, rect > title")) return;
    var at = -1;
    picture.setAttribute("tabindex", "0");
    picture.addEventListener("blur", hide);
    picture.addEventListener("keydown", function (event) {
      var step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
      if (event.key === "Enter" && chosen) pin(chosen);
      if (event.key === "Escape") {
        pinned = null;
        hide();
        link(null);
      }
      if (!step || event.shiftKey) return;
      event.preventDefault();
      var all = marks(picture);
      at = at < 0 && step < 0 ? all.length - 1 : (at + step + all.length) % all.length;
      all[at].scrollIntoView({ block: "nearest", inline: "nearest" });
      show(all[at], true);
    });
  });

  function element(name, parent, text, attributes) {
    var made = document.createElement(name);
    if (text) made.textContent = text;
    Object.keys(attributes || {}).forEach(function (key) { made.setAttribute(key, attributes[key]); });
    if (parent) parent.appendChild(made);
    return made;
  }
  function button(parent, text, act) {
    element("button", parent, text, { type: "button" }).addEventListener("click", act);
  }
  function save(name, type, text) {
    var link = element("a", null, "", { download: name, href: URL.createObjectURL(new Blob([text], { type: type })) });
    link.click();
    setTimeout(function () { URL.revokeObjectURL(link.href); }, 1000);
  }
  function copy(text) {
    if (navigator.clipboard) return navigator.clipboard.writeText(text);
    var area = element("textarea", document.body, text);
    area.select();
    document.execCommand("copy");
    area.remove();
  }

  // tables: sorted by a column, filtered by a text, copied and saved as they are shown
  function cells(row) { return Array.from(row.cells).map(function (cell) { return cell.textContent.trim(); }); }
  // heads with what stands above several of them: "before: mean"
  function fullHeads(table) {
    var rows = Array.from(table.tHead.rows), heads = cells(rows.pop()), above = [];
    if (rows.length) Array.from(rows[0].cells).forEach(function (cell) {
      for (var i = 0; i < cell.colSpan; i += 1) above.push(cell.textContent.trim());
    });
    return heads.map(function (head, i) { return above[i] ? above[i] + ": " + head : head; });
  }
  function shown(table) {
    return [fullHeads(table)].concat(Array.from(table.tBodies[0].rows).filter(function (row) { return !row.hidden; }).map(cells));
  }
  // a file is named by the words above its table: section, heading, what is folded, picture
  var named = {};
  function fileName(table) {
    var section = table.closest("section"), figure = table.closest("figure"), folded = table.closest("details"), heading = null;
    // an annex has its words in its section
    if (folded && folded.parentNode.classList.contains("annex")) folded = null;
    (section || document).querySelectorAll("h3").forEach(function (h) {
      if (h.compareDocumentPosition(table) & Node.DOCUMENT_POSITION_FOLLOWING) heading = h;
    });
    var above = [section && section.querySelector("h2"), figure ? figure.querySelector("figcaption b") : folded ? folded.querySelector("summary") : heading];
    var words = above.filter(Boolean).map(function (node) { return node.textContent; }).join(" ").toLowerCase();
    var name = words.match(/[\p{L}\p{M}\p{N}]+/gu);
    name = name ? name.join("-").slice(0, 100).replace(/-$/, "") : "table";
    named[name] = (named[name] || 0) + 1;
    return name + (named[name] > 1 ? "-" + named[name] : "") + ".csv";
  }
  var comma = document.documentElement.lang !== "en";
  function plain(text) { return comma && /^[-+−<> ]*\d+,\d+(e[-+]?\d+)?$/.test(text) ? text.replace(",", ".") : text; }
  function quoted(text) { return /[",\n]/.test(text) ? '"' + text.replace(/"/g, '""') + '"' : text; }
  // what is missing is last, whichever way
  function blank(text) { return !text || text === "—"; }
  function compare(a, b, sign) {
    var x = parseFloat(plain(a)), y = parseFloat(plain(b)), none = blank(a) - blank(b);
    return none || sign * (x !== x || y !== y ? a.localeCompare(b, undefined, { numeric: true }) : x - y);
  }
  document.querySelectorAll(".scroll > table").forEach(function (table) {
    var body = table.tBodies[0], wide = table.tHead;
    if (!wide || body.rows.length < 3) return;
    var name = fileName(table);
    var heads = Array.from(wide.rows[wide.rows.length - 1].cells), tools = element("div", null, "", { class: "tools" });
    table.parentNode.parentNode.insertBefore(tools, table.parentNode);
    heads.forEach(function (head, column) {
      var text = head.textContent;
      head.textContent = "";
      button(head, text, function () {
        var sign = head.getAttribute("aria-sort") === "ascending" ? -1 : 1;
        heads.forEach(function (other) { other.removeAttribute("aria-sort"); });
        head.setAttribute("aria-sort", sign > 0 ? "ascending" : "descending");
        var key = function (row) { return row.cells[column].textContent.trim(); };
        Array.from(body.rows).sort(function (a, b) { return compare(key(a), key(b), sign); })
          .forEach(function (row) { body.appendChild(row); });
      });
    });
    if (body.rows.length > 10) element("input", tools, "", { type: "search", placeholder: words[0], "aria-label": words[0] })
      .addEventListener("input", function () {
        var wanted = this.value.toLowerCase();
        Array.from(body.rows).forEach(function (row) { row.hidden = row.textContent.toLowerCase().indexOf(wanted) < 0; });
      });
    button(tools, words[1], function () {
      copy(shown(table).map(function (row) { return row.join("\t"); }).join("\n"));
    });
    button(tools, words[2], function () {
      save(name, "text/csv", shown(table).map(function (row) { return row.map(plain).map(quoted).join(","); }).join("\r\n"));
    });
  });

  // a long table in a frame is shown whole on request
  document.querySelectorAll(".scroll.tall + .rows").forEach(function (note) {
    var frame = note.previousElementSibling;
    note.appendChild(document.createTextNode(" "));
    button(note, words[9], function () { frame.classList.add("whole"); note.remove(); });
  });

  // what is wider than the window says so, as long as it is
  document.querySelectorAll(".scroll").forEach(function (wide) {
    var note = wide.previousElementSibling, before = wide;
    if (note && note.className === "tools") note = (before = note).previousElementSibling;
    if (!note || !note.classList.contains("sideways")) {
      note = element("p", null, words[8], { class: "sideways" });
      wide.parentNode.insertBefore(note, before);
    }
    function check() {
      var needed = wide.scrollWidth > wide.clientWidth + 1;
      note.classList.toggle("needed", needed);
      note.classList.toggle("spare", !needed);
    }
    if (window.ResizeObserver) new ResizeObserver(check).observe(wide);
    check();
  });

  // a picture as a file of its own, its texts and styles in it
  document.querySelectorAll("figure svg").forEach(function (picture) {
    var tools = element("div", null, "", { class: "tools" });
    picture.parentNode.parentNode.insertBefore(tools, picture.parentNode.nextSibling);
    button(tools, words[3], function () {
      var whole = picture.cloneNode(true), style = document.createElementNS(picture.namespaceURI, "style");
      style.textContent = "text { font: 12px sans-serif } " + document.getElementById("picture").textContent;
      whole.insertBefore(style, whole.firstChild);
      // programs that draw know the attribute, not the style
      whole.querySelectorAll("[style]").forEach(function (node) {
        node.setAttribute("transform", "translate(" + node.style.translate.replace(/px/g, "") + ")");
        node.removeAttribute("style");
      });
      marks(whole).forEach(function (mark) {
        var title = document.createElementNS(picture.namespaceURI, "title");
        title.textContent = text(mark);
        mark.appendChild(title);
      });
      save(picture.getAttribute("aria-labelledby").split("-title")[0] + ".svg", "image/svg+xml", new XMLSerializer().serializeToString(whole));
    });
    if (picture.dataset.turn) turning(picture, tools);
  });

  // a picture in space turns: with the pointer, the buttons, and shift and arrow keys
  function turning(picture, tools) {
    var start = picture.dataset.turn.split(" ").map(Number), at = start.slice(), scale = start[2], middle = picture.viewBox.baseVal.width / 2;
    var items = Array.from(picture.querySelectorAll("[data-at]")).map(function (node) {
      var v = node.dataset.at.split(" ").map(Number);
      return { node: node, a: v.slice(0, 3), b: v.slice(3) };
    });
    function flat(p, view) {
      var sa = Math.sin(view[0]), ca = Math.cos(view[0]), se = Math.sin(view[1]), ce = Math.cos(view[1]);
      return [middle + scale * (ca * p[1] - sa * p[0]), middle - scale * (ce * p[2] - se * (ca * p[0] + sa * p[1]))];
    }
    function turn(azimuth, elevation) {
      at[0] += azimuth;
      at[1] = Math.max(-1.57, Math.min(1.57, at[1] + elevation));
      items.forEach(function (item) {
        var to = flat(item.a, at), from = flat(item.a, start), end = item.b.length ? flat(item.b, at) : null;
        if (end) ["x1", "y1", "x2", "y2"].forEach(function (key, i) { item.node.setAttribute(key, to.concat(end)[i].toFixed(1)); });
        // beside the scale of a mark, which the style sheet sets
        else item.node.style.translate = (to[0] - from[0]).toFixed(1) + "px " + (to[1] - from[1]).toFixed(1) + "px";
      });
    }
    picture.turn = turn;
    picture.view = function (azimuth, elevation) { turn(azimuth - at[0], elevation - at[1]); };
    // both of a pair turn together
    function all(azimuth, elevation, absolute) {
      (picture.closest(".pair") || picture.parentNode).querySelectorAll("[data-turn]").forEach(function (one) { one[absolute ? "view" : "turn"](azimuth, elevation); });
      hide();
    }
    var held = null;
    picture.addEventListener("pointerdown", function (event) {
      held = [event.clientX, event.clientY];
      picture.setPointerCapture(event.pointerId);
    });
    picture.addEventListener("pointermove", function (event) {
      if (!held) return;
      all((held[0] - event.clientX) / 120, (event.clientY - held[1]) / 120);
      held = [event.clientX, event.clientY];
    });
    ["pointerup", "pointercancel"].forEach(function (name) { picture.addEventListener(name, function () { held = null; }); });
    picture.addEventListener("keydown", function (event) {
      var way = { ArrowLeft: [0.15, 0], ArrowRight: [-0.15, 0], ArrowUp: [0, 0.15], ArrowDown: [0, -0.15] }[event.key];
      if (!way || !event.shiftKey) return;
      event.preventDefault();
      all(way[0], way[1]);
    });
    [[0.3, 0], [-0.3, 0], [0, 0.2], [0, -0.2]].forEach(function (way, i) { button(tools, words[4 + i], function () { all(way[0], way[1]); }); });
    // along z, along y and along x, and as drawn
    [[-Math.PI / 2, 1.57], [-Math.PI / 2, 0], [0, 0], start].forEach(function (view, i) { button(tools, words[10 + i], function () { all(view[0], view[1], true); }); });
  }

  // scale and side of figures are remembered for the next report, where the browser allows it
  function remembered(key, value) {
    try {
      if (value !== undefined) localStorage.setItem(key, value);
      return localStorage.getItem(key);
    } catch (refused) { return null; }
  }
  document.querySelectorAll(".switch input").forEach(function (choice) {
    var kind = "etalon-" + (choice.name.endsWith("-scale") ? "scale" : "side");
    if (remembered(kind) === choice.value) choice.checked = true;
    choice.addEventListener("change", function () { remembered(kind, choice.value); });
  });

  // annexes are printed: the style sheet unfolds them where a browser knows ::details-content
  var unfolded = [];
  addEventListener("beforeprint", function () {
    unfolded = unfolded.concat(Array.from(document.querySelectorAll(".annex > details:not([open])")));
    unfolded.forEach(function (annex) { annex.open = true; });
  });
  addEventListener("afterprint", function () {
    unfolded.forEach(function (annex) { annex.open = false; });
    unfolded = [];
  });

  // an annex opens where it is named
  function unfold() {
    var annex = location.hash.length > 1 && document.getElementById(decodeURIComponent(location.hash.slice(1))), folded = annex && annex.querySelector(":scope > details");
    if (folded) folded.open = true;
  }
  addEventListener("hashchange", unfold);
  unfold();

  // the contents mark the section in sight
  var links = Array.from(document.querySelectorAll("nav a"));
  if (window.IntersectionObserver) {
    var observer = new IntersectionObserver(function (entries) {
      entries.filter(function (entry) { return entry.isIntersecting; }).forEach(function (entry) {
        links.forEach(function (link) {
          if (link.hash !== "#" + entry.target.id) return link.removeAttribute("aria-current");
          link.setAttribute("aria-current", "true");
          link.parentNode.scrollLeft = link.offsetLeft - link.parentNode.offsetLeft - 40;
        });
      });
    }, { rootMargin: "-10% 0px -80% 0px" });
    document.querySelectorAll("main > section").forEach(function (section) { observer.observe(section); });
  }
})();
