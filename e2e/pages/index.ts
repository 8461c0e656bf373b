/**
 * What the build hands to other test projects as dist/playwright.mjs: nothing else of this folder is meant for them.
 */
export { ClampingPage } from "./clamping.ts";
export { Comparison } from "./comparison.ts";
export { ContourTable } from "./contour-table.ts";
export { Course } from "./course.ts";
export { Dialog } from "./dialog.ts";
export { Effect } from "./effect.ts";
export { Findings } from "./findings.ts";
export { Handing } from "./handing.ts";
export { Lathe } from "./lathe.ts";
export { OwnCycles } from "./own-cycles.ts";
export { ProgramEditor } from "./program-editor.ts";
export { ProgramText } from "./program-text.ts";
export { SettingsPage } from "./settings.ts";
export { Setup } from "./setup.ts";
export { SetupSheetPage } from "./sheet.ts";
export { Start } from "./start.ts";
export { Teaching } from "./teaching.ts";
export { TaskPanel } from "./task.ts";
export { ToolTable } from "./tools.ts";
export { Turnwise } from "./turnwise.ts";
export { WorksList } from "./works.ts";
export type { Context } from "./context.ts";
export type { Options } from "./turnwise.ts";
