// Requests to the server, or the state inside an exported page.

import type { Message, PartMesh, Proposal, State, Watch, WhatIf, WhatIfAsked } from "./types";

export class Refused extends Error {
  constructor(readonly messages: Message[]) {
    super(messages.map(m => m.text).join("; "));
  }
}

/** State inside an exported page, if this page is one. */
export function exported(): State | null {
  const text = document.getElementById("state")?.textContent?.trim();
  return text ? (JSON.parse(text) as State) : null;
}

/** The token stays in the address: a reload sends it again, and no other page can read it. */
const token = new URLSearchParams(location.search).get("token") ?? "";

/** Times that a busy server is asked again, and the pause (ms) before. */
const AGAIN = 4;
const PAUSE = 250;

async function ask<T>(path: string, method = "GET", body?: BodyInit | object): Promise<T> {
  const headers: Record<string, string> = { "X-Etalon-Token": token };
  let sent: BodyInit | undefined;
  if (body instanceof Blob) sent = body;
  else if (body !== undefined) {
    sent = JSON.stringify(body);
    headers["Content-Type"] = "application/json";
  }
  const send = () => fetch(`/api/${path}`, { method, headers, body: sent, cache: "no-store", credentials: "omit" });
  let answer = await send();
  for (let again = 0; answer.status === 503 && again < AGAIN; again++) {
    await new Promise(done => setTimeout(done, PAUSE * 2 ** again));
    answer = await send();
  }
  const text = await answer.text();
  let read: unknown = null;
  try {
    read = text ? JSON.parse(text) : null;
  } catch {
    read = null;
  }
  if (!answer.ok) {
    const messages = (read as { messages?: Message[] } | null)?.messages;
    throw new Refused(messages ?? [{ id: "http", severity: "error", text: `HTTP ${answer.status} ${text.slice(0, 200)}` }]);
  }
  return read as T;
}

const named = (name: string): string => `files?name=${encodeURIComponent(name)}`;

export interface Answers {
  robot?: string;
  answers?: Record<string, string>;
}

export const api = {
  state: () => ask<State>("state"),
  meshes: () => ask<PartMesh[]>("meshes"),
  put: (name: string, file: Blob) => ask<State>(named(name), "POST", file),
  remove: (name: string) => ask<State>(named(name), "DELETE"),
  propose: (given: Answers) => ask<Proposal>("propose", "POST", given),
  accept: (given: Answers) => ask<State>("accept", "POST", given),
  check: () => ask<{ messages: Message[] }>("check", "POST", {}),
  run: () => ask<unknown>("run", "POST", {}),
  whatIf: (asked: WhatIfAsked) => ask<WhatIf>("whatif", "POST", asked),
  keep: (asked: WhatIfAsked, reason: string) => ask<{ difference: string }>("keep", "POST", { asked, reason }),
  download: (name: string) => `/api/download?name=${encodeURIComponent(name)}&token=${encodeURIComponent(token)}`,
  exportPage: () => `/api/export?token=${encodeURIComponent(token)}`,
};

export interface Events {
  progress(event: { text: string; share?: number }): void;
  state(event: { version: number }): void;
  watch(event: Watch): void;
  bye(): void;
  /** The connection is lost, or there again. */
  connected(there: boolean): void;
}

export function listen(events: Events): void {
  const source = new EventSource(`/api/events?token=${encodeURIComponent(token)}`);
  const on = (name: "progress" | "state" | "watch", take: (data: any) => void): void =>
    source.addEventListener(name, event => take(JSON.parse((event as MessageEvent<string>).data)));
  on("progress", data => events.progress(data));
  on("state", data => events.state(data));
  on("watch", data => events.watch(data));
  source.addEventListener("bye", () => {
    source.close();
    events.bye();
  });
  source.addEventListener("open", () => events.connected(true));
  source.addEventListener("error", () => events.connected(false));
}
