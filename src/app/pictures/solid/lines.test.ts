import { expect, test } from "vitest";
import { PIECE, piecesGeometry } from "./lines.ts";

test("each piece has its own corners, and the distance goes on from piece to piece", () => {
  const places = [0, 0, 0, 3, 4, 0, 3, 4, 0, 3, 4, -2.5],
    geometry = piecesGeometry(Float32Array.from(places)),
    index = geometry.index?.array ?? [];
  expect(index).toHaveLength(2 * PIECE);
  const numbers = (name: string, corner: number) => {
    const of = geometry.getAttribute(name);
    return Array.from({ length: of.itemSize }, (_, i) => of.getComponent(corner, i));
  };
  for (const [piece, distances] of [
    [0, [0, 5]],
    [1, [5, 7.5]],
  ] as const) {
    const corners = new Set(index.slice(PIECE * piece, PIECE * (piece + 1)));
    expect(corners.size).toBe(8);
    for (const corner of corners) {
      const ends = [...numbers("instanceStart", corner), ...numbers("instanceEnd", corner)];
      expect(ends).toEqual(places.slice(6 * piece, 6 * piece + 6));
      expect([...numbers("instanceDistanceStart", corner), ...numbers("instanceDistanceEnd", corner)]).toEqual(
        distances,
      );
    }
    const shapes = [...corners].map((corner) => numbers("position", corner).join());
    expect(new Set(shapes).size).toBe(8);
  }
});
