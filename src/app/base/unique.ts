import { z } from "zod/mini";

/** Checks untrusted rows: all ids are different. */
export const uniqueIds = z.refine<readonly { readonly id: string }[]>(
  (rows) => new Set(rows.map(({ id }) => id)).size === rows.length,
);
