import { useState } from "react";
import { fetchTexts } from "../../src/app/base/settings/loaded-texts.ts";
import type { Language } from "../../src/i18n/languages.ts";
import { createRoot } from "react-dom/client";
import "../../src/app/base/styles/base.css";
import { ContourTable } from "../../src/features/contour/ContourTable.tsx";
import { cycleByNumber } from "../../src/cycles/index.ts";
import { exampleJob, newRow, type ContourRow } from "../../src/program/job/job.ts";

const ask = new URLSearchParams(location.search);
if (ask.get("theme")) document.documentElement.dataset["theme"] = ask.get("theme") ?? "";
const cycle = cycleByNumber(820);
const example = cycle ? exampleJob(cycle).contour : [];
const more = newRow("e9", { kind: "CR", x: "0", z: "6", r: ask.get("r") ?? "14", turn: "ccw" });
const start = ask.get("more") ? [...example, more] : example;

function Page() {
  const [rows, setRows] = useState<readonly ContourRow[]>(start);
  return <ContourTable rows={rows} onChange={setRows} language={language} />;
}
const language = (ask.get("language") ?? "en") as Language;
await fetchTexts(language);
createRoot(document.getElementById("root")!).render(
  <div
    style={{
      padding: 12,
      width: Number(ask.get("width") ?? 400),
      boxSizing: "border-box",
      background: "var(--surface)",
    }}
  >
    <Page />
  </div>,
);
