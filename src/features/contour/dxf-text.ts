import type { Language } from "../../i18n/languages.ts";
import { formatNumber } from "../../i18n/number.ts";
import type { DxfIssue } from "../../program/dxf/read-dxf.ts";
import { texts } from "../../app/base/settings/loaded-texts.ts";

/** An issue of a drawing, as a sentence. */
export function dxfText(language: Language, found: DxfIssue): string {
  const say = texts(language).contour.dxf.of;
  const write = (n: number) => formatNumber(language, n, 4);
  switch (found.code) {
    case "skipped":
      return say.skipped(found.kind, write(found.count));
    case "broken":
      return say.broken(write(found.count));
    case "chains":
      return say.chains(write(found.count));
    case "branch":
      return say.branch(write(found.x), write(found.z));
    case "belowAxis":
      return say.belowAxis(write(found.x), write(found.z));
    case "gapsClosed":
      return say.gapsClosed(write(found.count), write(found.widest));
    default:
      return say[found.code];
  }
}
