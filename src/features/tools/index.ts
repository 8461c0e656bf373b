import { fetchTexts } from "../../app/base/settings/loaded-texts.ts";
import { useSettings } from "../../app/base/settings/settings.ts";

/* The tool table. */

const TEXTS = ["tables", "tool-files", "tool-sheets", "tool-codes"] as const;

/** The page with all its texts: what came later would push the form and the table away. */
export const fetchToolPage = async () => {
  const { language } = useSettings.getState();
  const [page] = await Promise.all([import("./ToolPage.tsx"), ...TEXTS.map((part) => fetchTexts(language, part))]);
  return page;
};
