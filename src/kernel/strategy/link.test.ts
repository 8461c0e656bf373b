import { describe, expect, test } from "vitest";
import { linePiece, upperEnvelope } from "../reach/envelope.ts";
import type { Flat, Frame } from "../geometry/flat.ts";
import { insertIn } from "./tip-envelope.ts";
import type { Move } from "../plan/move.ts";
import type { Tool } from "../plan/tool.ts";
import { roomOf } from "../plan/track.ts";
import { length } from "../units.ts";
import { Frontier } from "./frontier.ts";
import { Cutter, type Link } from "./link.ts";

/* The link between two cuts, over a step 5 high from u = 10 to u = 20, flat at 0 on either side. */
const frame: Frame = { transverse: false, signU: 1, signV: 1 };
const bar: Tool = {
  T: 1,
  NAME: "BAR",
  TYPE: "RECTURN",
  TO: 2,
  RS: length(0),
  CUTWIDTH: length(3),
  CUTLENGTH: length(30),
};
const around = { feature: "nose", on: "edge", corner: false } as const;
const flat = (u0: number, u1: number, v: number) => linePiece({ u: u0, v }, { u: u1, v }, around) ?? [];
const step = upperEnvelope([flat(0, 10, 0), flat(10, 20, 5), flat(20, 30, 0)].flat());

const purpose = { phase: "rough", run: "rough", step: 4 } as const;
const link: Link = { gap: 0.7, feed: 0.2, out: purpose, down: { ...purpose, step: 1 }, enter: { ...purpose, step: 2 } };
const linked = (from: Flat, to: Flat, roof = Infinity, before?: (cutter: Cutter) => void, tool = bar) => {
  const cutter = new Cutter(frame, "mm/rev", from, roomOf(frame), new Frontier(step, insertIn(tool, frame), roof), 50);
  before?.(cutter);
  const count = cutter.moves.length;
  cutter.link(to, link);
  return cutter.moves
    .slice(count)
    .map((m: Move) => `${m.kind} ${m.step} ${Number(m.to.z.toFixed(3))}/${Number(m.to.r.toFixed(3))}`);
};

describe("a link", () => {
  test("rises by the clearance above the stock, crosses, comes down at rapid to the clearance, then at feed", () => {
    expect(linked({ u: 5, v: 1 }, { u: 25, v: 0.1 })).toEqual([
      "rapid 4 5/5.7",
      "rapid 4 25/5.7",
      "rapid 1 25/0.7",
      "feed 2 25/0.1",
    ]);
  });
  test("crosses at the height of the higher end where that is clear", () => {
    expect(linked({ u: 5, v: 6 }, { u: 25, v: 6.4 })).toEqual(["rapid 4 5/6.4", "rapid 4 25/6.4"]);
    expect(linked({ u: 2, v: 1 }, { u: 8, v: 1 })).toEqual(["rapid 4 8/1"]);
  });
  test("retracts at feed while stock is above it, then at rapid", () => {
    expect(linked({ u: 15, v: 3 }, { u: 25, v: 1 })).toEqual([
      "feed 4 15/5",
      "rapid 4 15/5.7",
      "rapid 4 25/5.7",
      "rapid 1 25/1",
    ]);
  });
  test("at rapid comes down no lower than the clearance above the stock", () => {
    expect(linked({ u: 5, v: 9 }, { u: 15, v: 4 })).toEqual(["rapid 4 15/9", "rapid 1 15/5.7", "feed 2 15/4"]);
  });
  test("takes previous cuts into account", () => {
    const through = (cutter: Cutter) => {
      cutter.feed({ u: 25, v: 0.5 }, 0.2, purpose);
      cutter.feed({ u: 5, v: 0.5 }, 0.2, purpose);
    };
    expect(linked({ u: 5, v: 0.5 }, { u: 25, v: 0.5 }, Infinity, through)).toEqual(["rapid 4 25/0.5"]);
  });
  test("moves at feed next to a wall that overhangs after a cut with a round insert, and at rapid short of it", () => {
    const disc: Tool = { T: 2, NAME: "DISC", TYPE: "BUTTON", TO: 8, RS: length(3), CUTLENGTH: length(3) };
    const cut = (cutter: Cutter) => {
      cutter.feed({ u: 5, v: 0.5 }, 0.2, purpose);
      cutter.feed({ u: 12.5, v: 0.5 }, 0.2, purpose);
      cutter.feed({ u: 5, v: 1.9 }, 0.2, purpose);
    };
    expect(linked({ u: 5, v: 9 }, { u: 12.2, v: 1.9 }, Infinity, cut, disc)).toEqual(["feed 4 12.2/1.9"]);
    expect(linked({ u: 5, v: 9 }, { u: 9.2, v: 1.9 }, Infinity, cut, disc)).toEqual(["rapid 4 9.2/1.9"]);
  });
  test("moves at feed under a roof that may not be cut", () => {
    expect(linked({ u: 5, v: 1 }, { u: 25, v: 1 }, 3)).toEqual(["rapid 4 5/3.7", "feed 4 25/3.7", "rapid 1 25/1"]);
  });
});
