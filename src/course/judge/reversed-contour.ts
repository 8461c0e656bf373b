import type { Block } from "../../nc/program.ts";

/** An element of a contour: the coordinates of its end, or what is between two elements. */
interface Corner {
  readonly x: string;
  readonly z: string;
}

/** The coordinate that a path block writes for an axis, as text; null without one. */
export const coordinateOf = (raw: string, axis: "X" | "Z"): string | null =>
  new RegExp(String.raw`(?<![A-Z])${axis}[ \t]*([+-]?[\d.]+)`, "i").exec(raw.replace(/;.*$/s, ""))?.[1] ?? null;

/** The blocks between a label and LBL 0. */
function contourSpans(blocks: readonly Block[]): readonly (readonly [number, number])[] {
  return blocks.flatMap(({ statement: s }, i): (readonly [number, number])[] => {
    if (s.kind !== "label" || /LBL\s+0\b/.test(blocks[i]?.raw ?? "")) return [];
    const end = blocks.findIndex(({ raw }, k) => k > i && /LBL\s+0\b/.test(raw));
    return end < 0 ? [] : [[i + 1, end]];
  });
}

/**
 * The program with each of its contours in the other direction, one at a time. Only contours of straight lines with
 * roundings and chamfers between them: nobody writes an arc in reverse by a slip. `first`: index of its first block.
 */
export function reversedContours(
  blocks: readonly Block[],
): readonly { readonly first: number; readonly text: string }[] {
  return contourSpans(blocks).flatMap(([from, to]) => {
    const corners: Corner[] = [],
      between: (string | null)[] = [];
    let now: Corner = { x: "", z: "" },
      joined: string | null = null;
    for (const { raw, statement: s } of blocks.slice(from, to)) {
      const isCorner = s.kind === "chamfer" || (s.kind === "path" && s.path === "RND");
      if (isCorner) joined = raw.replace(/^\s*\d*\s*/, "").trim();
      else if (s.kind === "path" && s.path === "L") {
        now = { x: coordinateOf(raw, "X") ?? now.x, z: coordinateOf(raw, "Z") ?? now.z };
        between.push(joined);
        corners.push(now);
        joined = null;
      } else if (s.kind !== "comment" && s.kind !== "empty") return [];
    }
    if (corners.length < 3 || corners.some(({ x, z }) => x === "" || z === "")) return [];
    // A corner element stands behind the line to its corner, so it goes along with the corner.
    const lines = corners.toReversed().flatMap(({ x, z }, i) => {
      const joint = between[corners.length - i] ?? null;
      return [`L X${x} Z${z}`, ...(joint === null ? [] : [joint])];
    });
    const text = [
      ...blocks.slice(0, from).map(({ raw }) => raw),
      ...lines.map((line) => `${line}\n`),
      ...blocks.slice(to).map(({ raw }) => raw),
    ].join("");
    return [{ first: from, text }];
  });
}
