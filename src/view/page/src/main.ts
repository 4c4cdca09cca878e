// The page of `etalon view`.

import { api, exported, listen, Refused } from "./api";
import { Chart } from "./chart";
import { onDark } from "./colours";
import { options, player, Tabs } from "./controls";
import { button, fill, h } from "./dom";
import { badge, largest, messagesPanel, parameters, result, selected } from "./panels";
import { message, messages, progress } from "./parts";
import { Space } from "./space";
import { receive, start } from "./start";
import { leave, magnify, on, scene, sets, store, targets, tell } from "./store";
import { ErrorTable } from "./table";
import type { Message, State } from "./types";
import { band, watchPanel } from "./watch";
import { forget, leaveOut, whatIf } from "./whatif";
import { speak, t } from "./words";

declare const VERSION_THREE: string;
declare const VERSION_UPLOT: string;
declare const LICENCES: string;

const app = document.getElementById("app") as HTMLElement;
const notice = h("div", { class: "notices", role: "status" });
let isConnected = true;
let problems: Message[] = [];
let checked: Message[] | null = null;
let tabs: Tabs | null = null;
/** Mode and presence of a scene for which the page is laid out. */
let laid = "";

/** Takes a new state and lays the page out anew if its kind has changed. */
function take(state: State): void {
  const before = store.state;
  store.state = state;
  if (state.scene !== before?.scene) newScene();
  speak(state.language);
  document.title = `${state.name ?? "etalon view"} – etalon`;
  const kind = `${state.language} ${state.mode === "campaign"} ${Boolean(scene()) || Boolean(state.watching)}`;
  if (kind !== laid) {
    laid = kind;
    layOut();
  }
  tell("state");
  tell("scene");
}

/** Keeps the selected pose by its name, or follows the newest one, and proposes the magnification. */
let scenes: { pose?: string; last?: string } = {};
let isFirst = true;
function newScene(): void {
  const shown = scene();
  if (!shown) return;
  const isFollowed = (store.watch || store.state?.watching) && (!scenes.pose || scenes.pose === scenes.last);
  const at = isFollowed ? shown.poses.length - 1 : shown.poses.findIndex(pose => pose.id === scenes.pose);
  store.pose = Math.max(0, at);
  store.point = -1;
  if (!sets().includes(store.view.set)) store.view.set = "";
  if (!targets().includes(store.view.target)) store.view.target = "";
  const has = (key: "magnitude_after_um" | "magnitude_before_um") => shown.points.some(point => point[key] !== undefined);
  if (isFirst && !has("magnitude_after_um")) {
    store.view.colour = has("magnitude_before_um") ? "before" : "target";
    store.view.before = true;
  }
  isFirst = false;
  magnify();
  const id = (i: number) => shown.poses[i]?.id;
  scenes = { pose: id(store.pose), last: id(shown.poses.length - 1) };
}

async function guard(work: () => Promise<void>): Promise<void> {
  problems = [];
  try {
    await work();
  } catch (error) {
    problems =
      error instanceof Refused
        ? error.messages
        : [{ id: "request", severity: "error", text: `${t("failed")} ${String(error)}` }];
  }
  showNotice();
}

const refresh = (): Promise<void> => guard(async () => take(await api.state()));

const run = (): Promise<void> =>
  guard(async () => {
    checked = null;
    store.busy = { text: t("running") };
    tell("busy");
    try {
      await api.run();
    } catch (error) {
      store.busy = null;
      tell("busy");
      throw error;
    }
  });

const check = (): Promise<void> =>
  guard(async () => {
    checked = (await api.check()).messages;
  });

function showNotice(): void {
  const { busy, ended, offline, state } = store;
  fill(
    notice,
    offline && h("p", { class: "notice" }, t("offline", { name: state?.name ?? "" })),
    ended && h("p", { class: "notice warning" }, t("ended")),
    !ended && !isConnected && h("p", { class: "notice warning" }, t("lost")),
    busy && progress(busy.text, busy.share),
    store.what && h("p", { class: "notice what" }, t("whatIfBanner"), " ", button(t("reset"), forget, { class: "small" })),
    problems.length > 0 && h("ul", { class: "messages" }, ...problems.map(message)),
    checked &&
      h(
        "div",
        { class: "notice checked" },
        h("p", {}, t("checkDone", { count: checked.length }), " ", button(t("close"), closeCheck, { class: "small" })),
        messages(checked),
      ),
  );
}

function closeCheck(): void {
  checked = null;
  showNotice();
}

function header(): HTMLElement {
  const title = h("h1");
  const verdict = h("p", { class: "verdict" });
  const runs = button(t("run"), () => void run(), { class: "main", id: "run" });
  const checks = button(t("check"), () => void check(), { id: "check" });
  const actions = h("p", { class: "actions" }, checks, runs);
  const draw = () => {
    const { state } = store;
    fill(
      title,
      state?.name ?? (state?.mode === "campaign" ? state.folder : "etalon view"),
      state?.synthetic && h("small", { class: "tag" }, t("synthetic")),
    );
    const status = (store.what?.verdict ?? state?.verdict)?.status;
    const error = largest();
    fill(
      verdict,
      status && badge(status),
      error && h("span", { class: "largest" }, h("span", { class: "note" }, `${t("largest")}: `), h("b", {}, error)),
    );
    actions.hidden = store.offline || store.ended || state?.mode !== "campaign";
    runs.disabled = checks.disabled = store.busy !== null;
  };
  on(["state", "what", "busy", "online", "scene"], draw);
  draw();
  return h("header", { class: "head" }, h("div", {}, title, verdict), actions);
}

function footer(): HTMLElement {
  const dialog = h("dialog", { "aria-label": t("licences") });
  fill(
    dialog,
    h("pre", { tabindex: 0 }, LICENCES),
    button(t("close"), () => dialog.close(), { class: "main" }),
  );
  const { state } = store;
  return h(
    "footer",
    {},
    h("span", {}, `etalon ${state?.etalon ?? ""}`),
    h("span", {}, `three.js ${VERSION_THREE} (MIT)`),
    h("span", {}, `uPlot ${VERSION_UPLOT} (MIT)`),
    button(t("licences"), () => dialog.showModal(), { class: "link" }),
    state?.folder && h("span", { class: "folder" }, state.folder),
    dialog,
  );
}

function campaign(): HTMLElement {
  const shown = scene();
  tabs = new Tabs();
  const table = new ErrorTable();
  if (store.watch || store.state?.watching) tabs.add("watch", () => t("watchTab"), watchPanel());
  tabs.add("result", () => t("resultTab"), result());
  tabs.add("errors", () => t("errorsTab"), table.root);
  tabs.add("parameters", () => t("parametersTab"), parameters());
  tabs.add("messages", () => `${t("messages")} (${store.state?.messages.length ?? 0})`, messagesPanel());
  if (!store.offline && store.state?.scene) tabs.add("whatif", () => t("whatIfTab"), whatIf());
  const first = store.watch || store.state?.watching ? "watch" : store.state?.verdict || !shown ? "result" : "errors";
  tabs.show(first === "result" && !store.state?.verdict && store.state?.messages.length ? "messages" : first);
  const side = h(
    "div",
    { class: "side", id: "results" },
    selected(store.offline || !store.state?.scene ? null : leaveOut),
    tabs.root,
  );
  if (!shown) return h("main", { class: "main-page plain" }, side);
  const space = new Space();
  const robot = h("div", { class: "robot-view" }, space.root, player(), options(), new Chart().root);
  return h("main", { class: "main-page" }, robot, side);
}

function layOut(): void {
  const { state } = store;
  leave();
  tabs = null;
  const skip = h("a", { class: "skip", href: "#results" }, t("skip"));
  const parts = [header(), band(), notice];
  document.body.className = state?.mode === "campaign" ? "campaign" : "empty";
  if (state?.mode === "campaign") fill(app, skip, ...parts, campaign(), footer());
  else fill(app, ...parts, h("main", { id: "results" }, start(take, () => void refresh())), footer());
  showNotice();
}

function connect(): void {
  listen({
    progress: event => {
      store.busy = event;
      tell("busy");
    },
    state: event => {
      store.busy = null;
      tell("busy");
      if (event.version !== store.state?.version) {
        forget();
        void refresh();
      }
    },
    watch: event => {
      const hadScene = Boolean(scene());
      const hadWatch = Boolean(store.watch);
      // without a new scene the last one stays
      store.watch = { ...event, scene: event.scene ?? store.watch?.scene };
      newScene();
      if ((!hadScene && scene()) || !hadWatch) {
        laid = "";
        if (store.state) take(store.state);
      }
      tell("watch");
      if (event.scene) tell("scene");
    },
    bye: () => {
      store.ended = true;
      tell("online");
      showNotice();
    },
    connected: there => {
      const wasConnected = isConnected;
      isConnected = there;
      showNotice();
      if (!there || wasConnected) return;
      // an end of a run may have been missed
      store.busy = null;
      tell("busy");
      void refresh();
    },
  });
}

/** Files dropped anywhere on the page that has no campaign yet. */
function acceptDrops(): void {
  const isOpen = () => !store.offline && store.state?.mode !== "campaign";
  addEventListener("dragover", event => {
    event.preventDefault();
    document.body.classList.toggle("dragging", isOpen());
  });
  addEventListener("dragleave", event => {
    if (!event.relatedTarget) document.body.classList.remove("dragging");
  });
  addEventListener("drop", event => {
    event.preventDefault();
    document.body.classList.remove("dragging");
    if (isOpen() && event.dataTransfer?.files.length) void receive([...event.dataTransfer.files]);
  });
}

on(["selection"], () => (scenes.pose = scene()?.poses[store.pose]?.id), true);
on(["busy", "what", "online"], showNotice, true);
on(["state", "scene"], () => tabs?.relabel(), true);
onDark(() => tell("dark"));

async function begin(): Promise<void> {
  speak(navigator.language.slice(0, 2));
  acceptDrops();
  const inside = exported();
  if (inside) {
    store.offline = true;
    return take(inside);
  }
  fill(app, notice);
  await refresh();
  if (store.state) connect();
}

void begin();

