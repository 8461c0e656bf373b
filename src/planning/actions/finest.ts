import type { Chain } from "../types.ts";

/** The finest surface of a section, µm; undefined without a mark. */
export const finestOf = ({ marks }: Pick<Chain, "marks">): number | undefined => {
  const all = marks.flatMap(({ roughness }) => (roughness === undefined ? [] : [roughness]));
  return all.length > 0 ? Math.min(...all) : undefined;
};
