import { cleanup, render, waitFor } from "@testing-library/react";
import { afterAll, beforeAll, expect, test, vi } from "vitest";
import { cuttingCycles } from "../cycles/index.ts";
import { LANGUAGES, SCREEN_LANGUAGES, type Language } from "../i18n/languages.ts";
import type { PartName } from "../i18n/parts.ts";
import { exampleJob } from "../program/job/job.ts";
import { fetchTexts, partOf, texts } from "../app/base/settings/loaded-texts.ts";
import { changeSettings } from "../app/base/settings/settings.ts";
import { useEditor } from "../app/document/store.ts";
import { courseIndex } from "../app/records/course/content.ts";
import { startAutosave, startWork, useSavedWorks } from "../app/records/keep.ts";
import { useReports } from "../app/records/reports.ts";
import { App } from "./App.tsx";
import { CrashGuard } from "./CrashGuard.tsx";
import { followAddress } from "./follow-address.ts";

/** An added language: English, with each text between marks. */
const added = "xx" as Language;

function marked(value: unknown): unknown {
  if (typeof value === "string") return `⟦${value}⟧`;
  if (typeof value === "function")
    return (...values: readonly unknown[]) => marked(Reflect.apply(value, undefined, values));
  if (Array.isArray(value)) return value.map(marked);
  if (typeof value !== "object" || value === null) return value;
  return Object.fromEntries(Object.entries(value).map(([key, inner]: [string, unknown]) => [key, marked(inner)]));
}

const files = import.meta.glob("../i18n/en/*.ts");
const names = Object.keys(files)
  .map((path) => path.replace(/^.*\/|\.ts$/g, ""))
  .filter((name) => name !== "parts") as readonly PartName[];
const [cycle] = cuttingCycles;
let stops: readonly (() => void)[] = [];

beforeAll(async () => {
  // Missing in jsdom.
  Object.assign(HTMLDialogElement.prototype, { close: () => undefined, showModal: () => undefined });
  Element.prototype.scrollTo = () => undefined;
  Object.assign(SCREEN_LANGUAGES, { [added]: { ...SCREEN_LANGUAGES.en, name: "⟦English⟧" } });
  (LANGUAGES as Language[]).push(added);
  for (const name of names)
    partOf(name).provide(added, marked(partOf(name).cached("en") ?? (await fetchTexts("en", name))) as never);
  courseIndex.provide(added, await courseIndex.fetch("en"));
  changeSettings({ language: added });
  useSavedWorks.setState({ ready: true });
  stops = [startAutosave(), followAddress()];
});
afterAll(() => {
  stops.forEach((stop) => stop());
  cleanup();
  changeSettings({ language: "en" });
});

/** Shows an address, and waits for a text that only its page has. */
async function shows(hash: string, text: string): Promise<void> {
  location.hash = hash;
  await waitFor(() => expect(document.body.innerHTML).toContain(text));
  expect([hash, document.querySelector(".crash")]).toEqual([hash, null]);
}

test("every screen opens in a language that has been added", async () => {
  const faults = vi.spyOn(console, "error");
  render(
    <CrashGuard>
      <App />
    </CrashGuard>,
  );
  const { page, setup, params, findings } = texts(added),
    { tools, own } = texts(added, "tables"),
    guide = texts(added, "guide");
  await shows("#/", page.start.title);
  if (cycle) void startWork(exampleJob(cycle));
  await waitFor(() => expect(useEditor.getState().work).not.toBeNull());
  const work = `#/work/${useEditor.getState().work ?? ""}`;
  await shows(work, params.operation.label);
  await shows(`${work}/setup`, setup.spindle.title);
  await shows(`${work}/findings`, findings.title);
  await shows(`${work}/program`, page.text.languageLong);
  await shows(`${work}/sheet`, texts(added, "sheet").head.file);
  await shows("#/tools", tools.lead);
  await shows("#/own", own.lead);
  await shows(`#/guide/${cycle?.number}/Q460`, guide.facts);
  await shows("#/glossary", texts(added, "glossary").residue.text);
  await shows("#/course", texts(added, "course").lead);
  await shows("#/works", texts(added, "device").works.none);
  expect(faults.mock.calls).toEqual([]);
  expect(useReports.getState().list).toEqual([]);
});
