/*
 * The kinds of drawings by their file names. Apart from the readers, so that a page that only asks for a file need not
 * load them.
 */

/** Endings of file names by kind. */
export const ENDINGS_OF = {
  DXF: ["dxf"],
  STEP: ["step", "stp"],
  SVG: ["svg"],
} as const satisfies Readonly<Record<string, readonly string[]>>;
export type DrawingKind = keyof typeof ENDINGS_OF;

const KINDS = Object.keys(ENDINGS_OF) as DrawingKind[];

/** The names of the kinds, as they are said. */
export const DRAWING_KINDS: string = KINDS.join(", ");
/** All endings, as in `accept` of a file field. */
export const DRAWING_ENDINGS: readonly string[] = Object.values(ENDINGS_OF).flatMap((all) => all.map((e) => `.${e}`));

/** The kind of drawing that a file name says; null for other files. */
export function kindOfName(name: string): DrawingKind | null {
  const ending = /\.([^.]+)$/.exec(name.toLowerCase())?.[1] ?? "";
  return KINDS.find((kind) => ENDINGS_OF[kind].some((each) => each === ending)) ?? null;
}

/** Largest file that is read, bytes. */
export const LARGEST_DRAWING = 30_000_000;
