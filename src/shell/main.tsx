import { StrictMode } from "react";
import { createRoot } from "react-dom/client";
import { z } from "zod/mini";
import { parseAddress } from "../app/place/address.ts";
import { followAddress, resumePrompt } from "./follow-address.ts";
import { goTo } from "./page-address.ts";
import { App } from "./App.tsx";
import { CrashGuard } from "./CrashGuard.tsx";
import { startReports } from "../app/records/reports.ts";
import { startCalculationIdle } from "../app/calculation/start-idle.ts";
import { openShared } from "./open-shared.ts";
import { declareActions, onActionKey } from "../app/base/actions.ts";
import { historyActions } from "../app/document/history.ts";
import { useNotices } from "../app/base/notices.ts";
import { followMissing, retryImport } from "../app/base/parts.ts";
import "./slots.ts";
import { startAutosave, useSavedWorks } from "../app/records/keep.ts";
import { resume } from "./resume.ts";
import { watchOpening } from "./watch-opening.ts";
import { followAppearance } from "../app/base/settings/appearance.ts";
import { fetchTexts } from "../app/base/settings/loaded-texts.ts";
import { useSettings } from "../app/base/settings/settings.ts";
import { useEditor } from "../app/document/store.ts";
import "../app/base/styles/tokens.css";
import "../app/base/styles/base.css";
import "../app/base/styles/layout.css";
import "../app/base/styles/dialog.css";
import "../app/base/styles/panels.css";
import "../app/base/styles/start.css";
import { guardFocus } from "../app/base/focus-guard.ts";
import { guardPresses } from "../app/base/press-guard.ts";
import { PAGE_ACTIONS } from "../app/fields/keys/page-actions.ts";
import "../app/base/styles/short.css";
import "../app/base/styles/contrast.css";
import { startOfflineLater } from "../features/offline/first.ts";

z.config({ jitless: true });
startReports();
followAppearance();
followMissing();
startOfflineLater();
declareActions(() => [...historyActions(), ...PAGE_ACTIONS]);
document.addEventListener("keydown", onActionKey);
guardFocus();
guardPresses();
/** Starts saving the history in this tab and the picture of the work. The first screen waits for neither. */
async function startKeepingExtras(): Promise<void> {
  const [{ startKeepingSteps, takeKeptSteps }, { startKeepingPictures }] = await retryImport(() =>
    Promise.all([import("../app/records/keep-steps.ts"), import("../app/records/keep-pictures.ts")]),
  );
  takeKeptSteps();
  startKeepingSteps();
  startKeepingPictures();
  const { works } = useSavedWorks.getState();
  // Works of a newer edition are on the device, but not in the list.
  if (useNotices.getState().notices.includes("newerWorks")) return;
  const { forgetHandles } = await retryImport(() => import("../app/records/files/kept-handles.ts"));
  await forgetHandles(new Set(works.map(({ work }) => work)));
}

const begun = location.hash;
const asked = parseAddress(begun);
const askedWork =
  asked?.page === "work" ? asked.work : asked?.page === "start" || asked?.page === "course" ? null : undefined;
void resume(askedWork).then(async () => {
  resumePrompt();
  // A missing work has already been announced.
  if (asked && !(asked.page === "work" && asked.work !== useEditor.getState().work)) await goTo(asked);
  watchOpening();
  startAutosave();
  void startKeepingExtras();
  void retryImport(() => import("../app/base/styles/print.css"));
  startCalculationIdle();
  void openShared();
  followAddress(begun);
  addEventListener("hashchange", () => void openShared());
});

const root = document.getElementById("root");
void retryImport(() => fetchTexts(useSettings.getState().language, "first")).then(() => {
  if (!root) return;
  createRoot(root).render(
    <StrictMode>
      <CrashGuard>
        <App />
      </CrashGuard>
    </StrictMode>,
  );
});
