// Sorts, filters and draws the campaigns of a batch from the data of the page.
(function () {
  "use strict";
  var data = JSON.parse(document.getElementById("data").textContent), rows = data.rows, quantities = data.quantities;
  var CAMPAIGN = 0, REPORT = 1, ROBOT = 2, DATE = 3, ENDED = 4, MESSAGE = 5, VALUES = 6, OUTLIERS = 7, BADNESS = 8, CHECKS = 9, UNTIL = 10, LIMITS = 11;
  var COLOURS = ["#1f5fa8", "#f0a020", "#1d6b3a", "#8a3fa0", "#a3201d", "#2a8f9e", "#7a5a2a", "#5b6672"];
  // robots differ by more than their colour: outlines of about one area, in units of a mark's size
  var SHAPES = ["M-1 0a1 1 0 1 0 2 0a1 1 0 1 0 -2 0z", "M0 -1.25L1.25 0 0 1.25 -1.25 0z", "M-.89 -.89H.89V.89H-.89z", "M0 -1.35L1.35 1H-1.35z",
    "M0 1.35L1.35 -1H-1.35z", "M-.4 -1.2H.4V-.4H1.2V.4H.4V1.2H-.4V.4H-1.2V-.4H-.4z", "M-1.3 -.6H1.3V.6H-1.3z", "M-.6 -1.3H.6V1.3H-.6z"], STEP = 200, DAY = 864e5;
  var get = function (id) { return document.getElementById(id); };
  var table = get("campaigns"), body = table.tBodies[0], filter = get("filter"), choice = get("quantity"), trend = get("trend");
  var heads = Array.from(table.tHead.rows[0].cells), shown = STEP, chosen = [], sorted = { column: -1, down: true };
  var robots = Array.from(new Set(rows.map(function (row) { return row[ROBOT] || ""; })));

  function element(name, parent, text, attributes) {
    var made = name.startsWith("svg:") ? document.createElementNS("http://www.w3.org/2000/svg", name.slice(4)) : document.createElement(name);
    if (text !== null && text !== undefined) made.textContent = text;
    Object.keys(attributes || {}).forEach(function (key) { made.setAttribute(key, attributes[key]); });
    if (parent) parent.appendChild(made);
    return made;
  }
  var mark = document.documentElement.lang === "en" ? "." : ",";
  function said(value) { return value === null || value === undefined ? value : String(value).replace(".", mark); }
  // columns: campaign, verdict, cause, checks, robot, date, last day of validity, quantities
  var FIRST = 3, checks = rows.length ? rows[0][CHECKS].length : 0, FIGURES = FIRST + checks + 3;
  // a page is looked at later than it is written
  var today = new Date().toISOString().slice(0, 10);
  function cell(row, column) {
    if (column < 0) return row[BADNESS];
    if (column < FIRST) return [row[CAMPAIGN], row[ENDED][0], row[MESSAGE]][column];
    if (column < FIRST + checks) return row[CHECKS][column - FIRST][0];
    return column < FIGURES ? [row[ROBOT], row[DATE], row[UNTIL]][column - FIRST - checks] : row[VALUES][column - FIGURES];
  }
  function compare(a, b) {
    var x = cell(a, sorted.column), y = cell(b, sorted.column), sign = sorted.down ? -1 : 1;
    var none = function (v) { return v === null || v === undefined || v === ""; };
    // what is missing is last, whichever way
    if (none(x) || none(y)) return none(x) - none(y);
    if (sorted.column < 0 || sorted.column >= FIGURES) return sign * (x - y);
    return sign * String(x).localeCompare(String(y), undefined, { numeric: true });
  }
  function drawTable() {
    body.textContent = "";
    chosen.slice(0, shown).forEach(function (row) {
      var line = element("tr", body), head = element("th", line);
      element("bdi", row[REPORT] ? element("a", head, null, { href: row[REPORT] }) : head, row[CAMPAIGN]);
      element("td", line, row[ENDED][0], { class: "grade " + row[ENDED][1] });
      element("td", line, row[MESSAGE], { class: "long" });
      row[CHECKS].forEach(function (check) { element("td", line, check[0], check[1] ? { class: "grade " + check[1] } : {}); });
      element("bdi", element("td", line), row[ROBOT]);
      element("td", line, row[DATE]);
      var late = row[UNTIL] && row[UNTIL] < today;
      element("td", line, late ? row[UNTIL] + " (" + table.dataset.expired + ")" : row[UNTIL], late ? { class: "expired" } : {});
      row[VALUES].forEach(function (value, k) {
        element("td", line, said(value), { class: "num" + (row[OUTLIERS].indexOf(k) < 0 ? "" : " outlier") });
      });
    });
    get("more").hidden = chosen.length <= shown;
    get("count").textContent = get("count").dataset.text.replace("{0}", chosen.length).replace("{1}", rows.length);
  }
  function ticks(low, high) {
    var step = Math.pow(10, Math.floor(Math.log10(high - low || 1))), all = [];
    step = [step / 5, step / 2, step, 2 * step].find(function (s) { return (high - low) / s <= 6; });
    for (var at = Math.ceil(low / step) * step; at <= high + step / 1e6; at += step) all.push(Number(at.toPrecision(12)));
    return all;
  }
  function shape(robot) { return SHAPES[robot % SHAPES.length]; }
  // what is wider than the window says so, as long as it is
  function cues() {
    document.querySelectorAll(".scroll").forEach(function (wide) {
      var needed = wide.scrollWidth > wide.clientWidth + 1, note = wide.previousElementSibling;
      note.classList.toggle("needed", needed);
      note.classList.toggle("spare", !needed);
    });
  }
  function drawTrend() {
    var k = Number(choice.value), points = [], dated;
    trend.textContent = "";
    trend.hidden = !quantities.length;
    rows.forEach(function (row, i) { row.index = i + 1; });
    points = chosen.filter(function (row) { return row[VALUES][k] !== null && isFinite(row[VALUES][k]); });
    // by date where more than half have one
    var withDate = points.filter(function (row) { return Date.parse((row[DATE] || "").slice(0, 10)); });
    dated = 2 * withDate.length > points.length;
    if (dated) points = withDate;
    if (!points.length) return;
    var x = function (row) { return dated ? Date.parse(row[DATE].slice(0, 10)) / DAY : row.index; };
    var y = function (row) { return Number(row[VALUES][k]); };
    var limitOf = function (row) {
      var found = row[LIMITS].find(function (limit) { return limit[0] === k; });
      return found ? found[1] : null;
    };
    var limits = points.map(limitOf).filter(function (limit) { return limit !== null; });
    var range = function (of) {
      var all = of === y ? points.map(of).concat(limits) : points.map(of), low = all.reduce(function (a, b) { return Math.min(a, b); }), high = all.reduce(function (a, b) { return Math.max(a, b); });
      // marks keep away from the frame
      var margin = low < high ? 0.06 * (high - low) : 0.5;
      return [low - margin, high + margin];
    };
    var W = 900, H = 320, left = 80, bottom = 40, xs = range(x), ys = range(y);
    var px = function (v) { return left + (W - left - 20) * (v - xs[0]) / (xs[1] - xs[0]); };
    var py = function (v) { return H - bottom - (H - bottom - 20) * (v - ys[0]) / (ys[1] - ys[0]); };
    var label = quantities[k][0] + " [" + quantities[k][1] + "]";
    // letters of a phone's size: what is wider than the window scrolls and says so
    element("p", trend, trend.dataset.sideways, { class: "sideways" });
    var svg = element("svg:svg", element("div", trend, null, { class: "scroll", tabindex: "0" }), null, { viewBox: "0 0 " + W + " " + H, role: "img", "aria-label": label });
    ticks(ys[0], ys[1]).forEach(function (v) {
      element("svg:path", svg, null, { class: "grid", d: "M" + left + " " + py(v) + "H" + (W - 20) });
      element("svg:text", svg, said(v), { x: left - 6, y: py(v) + 4, class: "end" });
    });
    ticks(xs[0], xs[1]).forEach(function (v) {
      var text = dated ? new Date(v * DAY).toISOString().slice(0, 10) : v;
      if (v === Math.round(v)) element("svg:text", svg, text, { x: px(v), y: H - bottom + 18, class: "mid" });
    });
    element("svg:text", svg, label, { x: left, y: 12 });
    element("svg:text", svg, dated ? trend.dataset.date : trend.dataset.order, { x: W - 20, y: H - 6, class: "end" });
    // the history of a robot: its campaigns in the order of their dates
    if (dated) robots.forEach(function (robot) {
      var own = points.filter(function (row) { return (row[ROBOT] || "") === robot; }).sort(function (a, b) { return x(a) - x(b); });
      if (own.length > 1) element("svg:path", svg, null, { class: "history", d: "M" + own.map(function (row) { return px(x(row)).toFixed(1) + " " + py(y(row)).toFixed(1); }).join("L") });
    });
    points.forEach(function (row) {
      var limit = limitOf(row), at = px(x(row));
      if (limit !== null) element("svg:path", svg, null, { class: "limit", d: "M" + (at - 9).toFixed(1) + " " + py(limit).toFixed(1) + "h18" });
    });
    points.forEach(function (row) {
      var unlike = row[OUTLIERS].indexOf(k) >= 0, colour = COLOURS[robots.indexOf(row[ROBOT] || "") % COLOURS.length];
      var place = "translate(" + px(x(row)).toFixed(1) + " " + py(y(row)).toFixed(1) + ") scale(" + (unlike ? 6 : 4) + ")";
      var mark = element("svg:path", svg, null, { class: unlike ? "robot unlike" : "robot", d: shape(robots.indexOf(row[ROBOT] || "")), transform: place, fill: colour });
      element("svg:title", mark, [row[CAMPAIGN], row[ROBOT], row[DATE], said(row[VALUES][k])].filter(Boolean).join(", "));
    });
    var legend = element("figcaption", trend);
    robots.slice(0, COLOURS.length).forEach(function (robot, i) {
      var key = element("svg:svg", legend, null, { class: "key", viewBox: "-1.5 -1.5 3 3", "aria-hidden": "true" });
      element("svg:path", key, null, { d: shape(i), fill: COLOURS[i] });
      element("bdi", legend, robot + "  ");
    });
    if (robots.length > COLOURS.length) element("span", legend, "…");
    if (limits.length) {
      var line = element("svg:svg", legend, null, { class: "key", viewBox: "-1.5 -1.5 3 3", "aria-hidden": "true" });
      element("svg:path", line, null, { class: "limit", style: "stroke-width: .4; stroke-dasharray: none", d: "M-1.5 0h3" });
      element("span", legend, trend.dataset.limit);
    }
    cues();
  }
  function draw() {
    var asked = filter.value.toLowerCase().split(/\s+/).filter(Boolean);
    chosen = rows.filter(function (row) {
      var text = [row[CAMPAIGN], row[ROBOT], row[DATE], row[ENDED][0], row[MESSAGE]].join(" ").toLowerCase();
      return asked.every(function (word) { return text.indexOf(word) >= 0; });
    }).sort(compare);
    shown = STEP;
    drawTable();
    drawTrend();
  }

  heads.forEach(function (head, column) {
    var button = element("button", null, head.textContent, { type: "button" });
    head.textContent = "";
    head.appendChild(button);
    button.addEventListener("click", function () {
      sorted = { column: column, down: sorted.column === column && !sorted.down };
      heads.forEach(function (other) { other.removeAttribute("aria-sort"); });
      head.setAttribute("aria-sort", sorted.down ? "descending" : "ascending");
      draw();
    });
  });
  quantities.forEach(function (q, k) { element("option", choice, q[0] + " [" + q[1] + "]", { value: k }); });
  choice.addEventListener("change", drawTrend);
  filter.addEventListener("input", draw);
  get("more").addEventListener("click", function () { shown += STEP; drawTable(); });
  document.querySelector(".controls").hidden = false;
  if (get("left-out")) get("left-out").hidden = true;
  addEventListener("resize", cues);
  draw();
})();
