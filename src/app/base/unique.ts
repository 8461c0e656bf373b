import { z } from "zod/mini";

/** A check of rows from outside: no two have one id. */
export const uniqueIds = z.refine<readonly { readonly id: string }[]>(
  (rows) => new Set(rows.map(({ id }) => id)).size === rows.length,
);
