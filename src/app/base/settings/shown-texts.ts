import { fetchTexts } from "./loaded-texts.ts";
import { useSettings } from "./settings.ts";

/** Fetches all texts of the screen language, which may change on the way. */
export async function fetchShownTexts(): Promise<void> {
  const { language } = useSettings.getState();
  await fetchTexts(language);
  if (useSettings.getState().language !== language) await fetchShownTexts();
}
