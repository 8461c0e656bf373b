import { z } from "zod/mini";
import { keptData } from "../base/kept.ts";
import type { Thumbnail } from "../../view/thumbnail.ts";

/** Works that have one, and characters of one path. */
const MOST = { works: 100, path: 6000 };

const box = z.tuple([z.number(), z.number(), z.number(), z.number()]);
const path = z.string().check(z.maxLength(MOST.path), z.regex(/^[MLZ\d .-]*$/));
/** Pictures of works, by name; they are a convenience, and whatever happens to them no work is lost. */
const KEPT = keptData<Readonly<Record<string, Thumbnail>>>(
  "pictures",
  z.record(z.string(), z.object({ box, part: path, blank: path })),
);

/** How the parts of works were last seen, by the names of the works. */
export const keptPictures = (): Readonly<Record<string, Thumbnail>> => KEPT.get() ?? {};

/** Notes how the part of a work looks. The oldest gives way; a browser without room goes without. */
export function keepPicture(work: string, picture: Thumbnail): void {
  if (picture.part.length > MOST.path || picture.blank.length > MOST.path) return;
  const others = Object.entries(keptPictures())
    .filter(([name]) => name !== work)
    .slice(1 - MOST.works);
  KEPT.set(Object.fromEntries([...others, [work, picture]]));
}
