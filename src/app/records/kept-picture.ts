import { z } from "zod/mini";
import { measure } from "../../program/files/bounded.ts";
import { storedData } from "../base/storage.ts";
import type { Thumbnail } from "../../view/thumbnail.ts";

/** Most thumbnails, and characters of one path. */
const MOST = { works: 100, path: 6000 };

const box = z.tuple([measure, measure, measure, measure]);
const path = z.string().check(z.maxLength(MOST.path), z.regex(/^[MLZ\d .-]*$/));
const milled = z.object({ stock: z.nullable(box), ways: z.array(z.object({ d: path, wide: measure })) });
/** Thumbnails by work. Losing them loses no work. */
const KEPT = storedData<Readonly<Record<string, Thumbnail>>>(
  "pictures",
  z.record(z.string(), z.object({ box, part: path, blank: path, milled: z.optional(milled) })),
);

/** Thumbnails by work. A map, since the name of a work from a backup may be that of a property of every object. */
export const keptPictures = (): ReadonlyMap<string, Thumbnail> => new Map(Object.entries(KEPT.get() ?? {}));

/** Stores a thumbnail. The oldest is dropped; without space nothing is stored. */
export function keepPicture(work: string, picture: Thumbnail): void {
  const { part, blank, milled } = picture;
  if ([part, blank, ...(milled?.ways ?? []).map(({ d }) => d)].some(({ length }) => length > MOST.path)) return;
  const others = [...keptPictures()].filter(([name]) => name !== work).slice(1 - MOST.works);
  KEPT.set(Object.fromEntries([...others, [work, picture]]));
}
