import type { UndercutTexts } from "../../../i18n/en/undercuts.ts";
import { breadthOnFace, type NamedUndercut, type UndercutNote } from "../../../program/job/undercut-name.ts";

/** The sizes of a standard, with its letters. */
export function sizesText({ groove, relief, udc }: NamedUndercut, write: (n: number) => string): string {
  if (relief) {
    const sign = relief.form === "A" || relief.form === "B" ? "d − " : "D + ";
    return `dg = ${sign}${write(relief.apart)} · g1 ${write(relief.floor)} · g2 ${write(relief.broad)} · r ${write(relief.R)}`;
  }
  if (!groove) return "";
  const g = breadthOnFace(groove);
  return [
    `r ${write(groove.r)}`,
    `t1 ${write(groove.t1)}`,
    `f ${write(groove.f)}`,
    ...(g === null ? [] : [`g ${write(g)}`]),
    ...(groove.t2 > 0 ? [`t2 ${write(groove.t2)}`] : []),
    udc?.words.FACEANGLE === undefined ? "15°" : "15°/8°",
  ].join(" · ");
}

/** A designation with the decimal sign of the reader. */
export const nameText = (name: string, write: (n: number) => string): string =>
  name.replace(/(?<!\d)\d+\.\d+/g, (n) => write(Number(n)));

/** What to know about a size. */
export function noteText({ notes: t }: UndercutTexts, note: UndercutNote, write: (n: number) => string): string {
  switch (note.code) {
    case "nearest":
      return t.nearest(nameText(note.asked, write), nameText(note.taken, write));
    case "diameter":
      return t.diameter(write(note.over), Number.isFinite(note.upTo) ? write(note.upTo) : null);
    case "side":
      return t.side(note.form, note.other);
    case "pitch":
      return t.pitch(write(note.pitch));
    case "faceOfH":
      return t.faceOfH(write(note.t2));
    case "allowance":
      return t.allowance(write(note.z));
    default:
      return t.formG;
  }
}
