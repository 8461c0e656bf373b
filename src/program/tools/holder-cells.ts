import { hullOf } from "../../kernel/cutter/hull.ts";
import type { Holder } from "../../kernel/plan/tool.ts";

/** Corners of a head as typed: parts separated by a semicolon, corners by a blank, each as Z/X in mm. */
export const writeHead = (head: Holder["head"]): string =>
  (head ?? []).map((part) => part.map(([z, x]) => `${z}/${x}`).join(" ")).join("; ");

/** Most parts of a head, and most corners of a part. */
export const MOST_PARTS = 8;
export const MOST_CORNERS = 16;
const FAR = 99999.9999;

type Corner = readonly [number, number];

const NUMBER = String.raw`[+-]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][+-]?\d+)?`;
const CORNER = new RegExp(`^(${NUMBER})/(${NUMBER})$`);

function corner(text: string): Corner | null {
  const found = CORNER.exec(text);
  if (!found) return null;
  const [z, x] = [found[1], found[2]].map((n) => Number((n ?? "").replace(",", "."))) as [number, number];
  return Math.abs(z) <= FAR && Math.abs(x) <= FAR ? [z, x] : null;
}

/** Whether corners form parts with an area, within the limits. */
export const soundHead = (head: readonly (readonly Corner[])[]): boolean =>
  head.length <= MOST_PARTS && head.every((part) => part.length <= MOST_CORNERS && hullOf(part).length > 2);

/** Reads a typed head: its parts, none for an empty text, null when invalid. */
export function readHead(text: string): readonly (readonly Corner[])[] | null {
  if (text.trim() === "") return [];
  const parts = text
    .trim()
    .replace(/;\s*$/, "")
    .split(";")
    .map((part) => part.trim().split(/\s+/).map(corner));
  if (!parts.every((part): part is Corner[] => part.every((c) => c !== null))) return null;
  return soundHead(parts) ? parts : null;
}

/** Reads the axis of a shank: empty follows the tool orientation; null when invalid. */
export const readAxis = (text: string): "X" | "Z" | "" | null => {
  const axis = text.trim().toUpperCase();
  return axis === "X" || axis === "Z" || axis === "" ? axis : null;
};
