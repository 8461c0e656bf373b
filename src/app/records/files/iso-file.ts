import { ncLanguageOf } from "../../../i18n/languages.ts";
import { retryImport } from "../../base/parts.ts";
import { notice } from "../../base/notices.ts";
import { useSettings } from "../../base/settings/settings.ts";
import type { WorkFile } from "../../document/work.ts";

/** True if a text may be DIN/ISO; only then its reader, which decides, is loaded. */
export const mayBeIso = (text: string): boolean =>
  !/BEGIN PGM/i.test(text) && /^[ \t\ufeff]*(?:%|(?:\/(?:N?\d*)[ \t]*|N\d*[ \t]*|\d+[ \t]*)?G[ \t]*\d)/im.test(text);

/** A text file as Klartext. DIN/ISO is converted under the same name, with a notice. */
export async function asKlartext(file: WorkFile): Promise<WorkFile> {
  if (!mayBeIso(file.text)) return file;
  const [{ isIsoText }, { klartextOfIso }, { isoNames }, { ncLabels }, { LAYOUTS }] = await retryImport(() =>
    Promise.all([
      import("../../../nc/iso/lines.ts"),
      import("../../../nc/iso/read-iso.ts"),
      import("../../../program/job/iso-names.ts"),
      import("../../../i18n/nc-labels.ts"),
      import("../../../nc/style.ts"),
    ]),
  );
  if (!isIsoText(file.text)) return file;
  const { control, language } = useSettings.getState();
  const style = {
    ...LAYOUTS[control === "TNC7" ? "tnc7" : "tnc640"],
    newLine: file.text.includes("\r\n") ? "\r\n" : "\n",
  } as const;
  const { text } = klartextOfIso(file.text, style, isoNames(ncLabels(ncLanguageOf(language))));
  notice("isoRead");
  return { ...file, name: `${file.name.replace(/\.(?:i|h)$/i, "")}.h`, text };
}
