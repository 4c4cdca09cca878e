// The empty page: drop files, see what each column is taken for, answer, accept.

import { api, Refused, type Answers } from "./api";
import { button, fill, h, prose, redraw } from "./dom";
import { bytes } from "./numbers";
import { difference, message, messages, region, scroller } from "./parts";
import { on, store } from "./store";
import type { Message, Proposal, State } from "./types";
import { t } from "./words";

/** Id of the question about the robot. */
const ROBOT = "robot";
/** Options that are buttons; of a longer list only the first ones. */
const MOST = 8;
const FIRST = 4;

let proposal: Proposal | null = null;
let given: Answers = {};
let problems: Message[] = [];
/** Texts that are typed but not sent, by question. */
const drafts = new Map<string, string>();
let isReading = false;
let asking = 0;
let take: (state: State) => void = () => {};
let done: () => void = () => {};

const refused = (error: unknown): Message[] =>
  error instanceof Refused ? error.messages : [{ id: "request", severity: "error", text: `${t("failed")} ${String(error)}` }];

let draw: () => void = () => {};
let reading = 0;

async function guard(work: () => Promise<void>): Promise<void> {
  reading += 1;
  isReading = true;
  problems = [];
  draw();
  try {
    await work();
  } catch (error) {
    problems = refused(error);
  }
  reading -= 1;
  isReading = reading > 0;
  draw();
}

async function propose(): Promise<void> {
  if (!store.state?.files.length) {
    proposal = null;
    return;
  }
  const mine = ++asking;
  const answered = await api.propose(given);
  // a later answer has its own proposal
  if (mine !== asking) return;
  proposal = answered;
  if (proposal.robot && !given.robot) given = { ...given, robot: proposal.robot };
}

export function receive(files: Iterable<File>): Promise<void> {
  return guard(async () => {
    const refusals: Message[] = [];
    for (const file of files)
      try {
        take(await api.put(file.name, file));
      } catch (error) {
        refusals.push(...refused(error));
      }
    if (refusals.length) {
      await propose();
      throw new Refused(refusals);
    }
    await propose();
  });
}

function answer(id: string, value: string): void {
  drafts.set(id, value);
  const typed = Object.fromEntries([...drafts].filter(([key, text]) => key !== ROBOT && text));
  given = { robot: id === ROBOT ? value : given.robot, answers: { ...given.answers, ...typed } };
  void guard(propose);
}

/** The start page. `took` receives a new state, `accepted` is called when campaign.toml is written. */
export function start(took: (state: State) => void, accepted: () => void): HTMLElement {
  take = took;
  done = accepted;
  const root = h("div", { class: "start" });
  const drop = dropZone();
  const rest = h("div", { class: "rest" });
  const status = h("p", { class: "note", role: "status" });
  fill(root, drop, status, rest);
  draw = () => {
    drop.classList.toggle("small", Boolean(store.state?.files.length));
    status.textContent = isReading ? t("reading") : "";
    redraw(rest, () => fill(rest, ...restParts()));
  };
  on(["state"], draw);
  draw();
  if (store.state?.files.length) void guard(propose);
  return root;
}

function dropZone(): HTMLElement {
  const input = h("input", { type: "file", multiple: true, id: "files", class: "hidden", tabindex: -1, "aria-label": t("chooseFiles") });
  input.addEventListener("change", () => {
    if (input.files?.length) void receive([...input.files]);
    input.value = "";
  });
  return h(
    "section",
    { class: "drop", "aria-label": t("files") },
    h("p", { class: "big", "aria-hidden": "true" }, "⤓"),
    h("h1", {}, t("dropHere")),
    h("p", {}, button(t("chooseFiles"), () => input.click(), { class: "main" }), input),
    h("p", { class: "note" }, t("dropNote")),
  );
}

/** What will happen, before anything has. */
const outlook = (): HTMLElement =>
  h("ol", { class: "steps outlook" }, ...(["step1", "step2", "step3", "step4"] as const).map(step => h("li", {}, t(step))));

function restParts(): (HTMLElement | null)[] {
  const state = store.state;
  if (!state?.files.length && !problems.length) return [outlook()];
  const parts: (HTMLElement | null)[] = [];
  if (problems.length) parts.push(h("ul", { class: "messages", role: "alert" }, ...problems.map(message)));
  if (state?.files.length) parts.push(fileList(state), robotField());
  if (!proposal) return parts;
  const { questions, files, messages: said } = proposal;
  if (questions.length)
    parts.push(h("section", { class: "questions" }, h("h2", {}, `${t("openQuestions")} (${questions.length})`), ...questions.map(question)));
  if (said.length) parts.push(h("section", {}, h("h2", {}, t("messages")), messages(said)));
  parts.push(...files.map(fileTable));
  const text = proposal.difference ?? proposal.campaign;
  parts.push(
    h(
      "section",
      { class: "written" },
      h("h2", {}, proposal.difference ? t("difference") : t("campaignText")),
      difference(text, t("campaignText")),
      h(
        "p",
        { class: "actions sticky" },
        button(t("accept"), () => void guard(acceptIt), { class: "main", "data-key": "accept", disabled: isReading }),
      ),
    ),
  );
  return parts;
}

async function acceptIt(): Promise<void> {
  const state = await api.accept(given);
  proposal = null;
  take(state);
  done();
}

function fileList(state: State): HTMLElement {
  const remove = (name: string) =>
    guard(async () => {
      take(await api.remove(name));
      await propose();
    });
  return h(
    "section",
    {},
    h("h2", {}, t("files")),
    h(
      "ul",
      { class: "files" },
      ...state.files.map(file =>
        h(
          "li",
          {},
          h("b", {}, file.name),
          h("span", { class: "note" }, ` ${bytes(file.bytes)}${file.role ? `, ${file.role}` : ""} `),
          button("✕", () => void remove(file.name), { class: "small", "aria-label": t("remove", { name: file.name }), "data-key": `r${file.name}` }),
        ),
      ),
    ),
  );
}

/** The chosen robot, which can be chosen anew. */
function robotField(): HTMLElement | null {
  if (!given.robot || proposal?.questions.some(q => q.id === ROBOT)) return null;
  const again = () => {
    given = { ...given, robot: undefined };
    void guard(propose);
  };
  return h(
    "p",
    { class: "row" },
    h("span", {}, `${t("robot")}: `, h("b", {}, given.robot)),
    button(t("change"), again, { class: "small", "data-key": "robot" }),
  );
}

function question(q: Proposal["questions"][number]): HTMLElement {
  const chosen = q.id === ROBOT ? given.robot : given.answers?.[q.id];
  const list = q.options ?? [];
  const options = list.slice(0, list.length > MOST ? FIRST : MOST).map(option =>
    button(option.label, () => answer(q.id, option.value), {
      class: "option",
      "aria-pressed": String(chosen === option.value),
      "data-key": `q${q.id}=${option.value}`,
    }),
  );
  const others = h("select", { class: "option", "aria-label": q.text, "data-key": `o${q.id}` });
  fill(others, h("option", { value: "" }, t("others")));
  for (const option of list.slice(options.length)) others.append(h("option", { value: option.value }, option.label));
  others.addEventListener("change", () => others.value && answer(q.id, others.value));
  const input = h("input", { id: `q-${q.id}`, "aria-label": q.text, "data-key": `q${q.id}` });
  input.value = drafts.get(q.id) ?? chosen ?? "";
  input.addEventListener("input", () => drafts.set(q.id, input.value.trim()));
  const send = (event: Event) => {
    event.preventDefault();
    if (input.value.trim()) answer(q.id, input.value.trim());
  };
  return h(
    "fieldset",
    { class: chosen === undefined ? "question" : "question answered" },
    h("legend", {}, chosen !== undefined && "✓ ", q.text),
    q.doubt && h("p", { class: "note" }, prose(q.doubt)),
    options.length
      ? h("p", { class: "options" }, ...options, list.length > options.length && others)
      : h("form", { class: "row", onsubmit: send }, input, h("button", { type: "submit", "data-key": `s${q.id}` }, t("answer"))),
  );
}

function fileTable(file: Proposal["files"][number]): HTMLElement {
  const title = t("firstRows", { file: file.name });
  const isTable = file.columns.length > 0;
  return h(
    "section",
    { class: "first-rows" },
    h("h2", {}, title),
    isTable &&
      scroller(
        region(title),
        h(
          "table",
          {},
          h(
            "thead",
            {},
            h("tr", {}, ...file.columns.map(c => h("th", { scope: "col" }, c.heading))),
            h(
              "tr",
              { class: "taken" },
              ...file.columns.map(c =>
                h(
                  "td",
                  {},
                  h("span", { class: "hidden" }, `${t("takenFor")}: `),
                  c.taken_for ? h("b", {}, c.taken_for) : h("i", {}, t("notTaken")),
                  c.why && h("small", {}, c.why),
                ),
              ),
            ),
          ),
          h(
            "tbody",
            {},
            ...file.rows.map(row => h("tr", {}, ...file.columns.map((_, i) => h("td", {}, row[i] ?? "")))),
          ),
        ),
      ),
    file.lines?.length ? difference(file.lines.join("\n"), title) : null,
  );
}

