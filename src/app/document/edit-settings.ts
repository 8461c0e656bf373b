import { changeLanguage, changeSettings, useSettings, type Settings } from "../base/settings/settings.ts";
import { SETTINGS } from "./documents.ts";
import { continuesStep, recordStep, stepBetween } from "./steps.ts";

/** Sets settings; the language once its texts are loaded. */
function putSettings({ language, ...others }: Partial<Settings>): void {
  changeSettings(others);
  if (language !== undefined) void changeLanguage(language);
}

/**
 * Changes settings as one step of undo; successive changes at the same place are one step. For what an operator sets in
 * a dialog; what only the view shows is changed without.
 */
export async function editSettings(change: Partial<Settings>, place: string | null = null): Promise<void> {
  const now = useSettings.getState();
  const before = Object.fromEntries(Object.keys(change).map((name) => [name, now[name as keyof Settings]]));
  const { language = now.language, ...others } = change;
  changeSettings(others);
  if (language !== now.language) await changeLanguage(language);
  recordStep(stepBetween<Partial<Settings>>(SETTINGS, putSettings, before, change), continuesStep(place));
}
