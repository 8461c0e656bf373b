import fc from "fast-check";
import { expect, test } from "vitest";
import { refusals } from "../../src/control-file/refusals.ts";
import { areaOf } from "../../src/kernel/area/area.ts";
import { difference, offset, union } from "../../src/kernel/area/clip.ts";
import { at, type Pt, type Ring } from "../../src/kernel/geometry/point.ts";
import { parse } from "../../src/nc/parse.ts";
import { NC_OUTPUTS } from "../../src/program/machine/nc-output.ts";
import { run } from "../../src/program/run/run.ts";
import { secondSide, flippedPiece } from "../../src/program/edits/second-side.ts";
import { shippedTools } from "../../src/program/tools/shipped-tools.ts";
import { regionsOf } from "../../src/sim/region.ts";
import { simulate } from "../../src/sim/simulate.ts";

/** Allowed change of the stock between two clampings, mm²: the decimals of an inch are coarser. */
const SAME_STOCK = { MM: 0.01, INCH: 0.03 };
/** Distance within which a point is on a surface, mm: both sides have arcs as chords. */
const NEAR = 0.006;
/** The smallest piece worth turning round, mm². */
const PIECE = 1;

const grid = (min: number, max: number) => fc.integer({ min: min * 1000, max: max * 1000 }).map((n) => n / 1000);
const places = fc.tuple(grid(-65, 5), grid(-5, 45)).map(([z, r]) => at(z, r));
const below: Ring = [at(-100, -100), at(100, -100), at(100, 0), at(-100, 0)];

/** A bar or a tube minus a few shapes with sharp or round corners: pieces, bores, undercuts and cavities. */
const stocks = fc
  .tuple(
    fc.constantFrom(0, 5, 12.3456),
    fc.array(fc.tuple(fc.array(places, { minLength: 3, maxLength: 4 }), fc.constantFrom(0, 0.2, 0.4, 0.8, 3, 12.5)), {
      minLength: 1,
      maxLength: 6,
    }),
  )
  .map(([bore, cuts]) => {
    const blank: Ring = [at(-60, bore), at(0, bore), at(0, 40), at(-60, 40)];
    const taken = cuts.flatMap(([shape, round]) => (round > 0 ? offset(union(convex(shape)), round) : convex(shape)));
    return difference(difference([blank], taken), [below]);
  });
const convex = (shape: readonly Pt[]): Ring[] => (areaOf([shape]) < 0 ? [[...shape].reverse()] : [shape]);

const FIRST = (unit: "MM" | "INCH") =>
  parse(`0 BEGIN PGM PART ${unit}\n1 TOOL CALL 1\n2 M30\n3 END PGM PART ${unit}\n`);
const OUTPUT = NC_OUTPUTS.manual;
const blankOf = (text: string): readonly Ring[] => run(parse(text), { tools: shippedTools, rapid: 10_000 }).blank;
/** The area of one stock outside the other and its tolerance, mm². */
const beyond = (a: readonly Ring[], b: readonly Ring[]) => areaOf(difference(a, offset(b, NEAR)));

/** The differences between the expected stock and a program's blank, in words. */
function differences(should: readonly Ring[], is: readonly Ring[], unit: "MM" | "INCH"): string[] {
  const change = areaOf(is) - areaOf(should),
    [more, less] = [beyond(is, should), beyond(should, is)];
  return [
    ...(Math.abs(change) > SAME_STOCK[unit] ? [`${change} mm² more`] : []),
    ...(more > 0 || less > 0 ? [`${more} mm² stand out, ${less} mm² are missing`] : []),
  ];
}

const pieces = (stock: readonly Ring[]) => regionsOf(stock, PIECE).map(({ outline, holes }) => [outline, ...holes]);

test("a reversed part is read back unchanged, and reversed twice it is the original", () => {
  fc.assert(
    fc.property(stocks, fc.constantFrom("MM", "INCH"), grid(0, 3), (stock, unit, allowance) => {
      for (const piece of pieces(stock)) {
        const text = secondSide(FIRST(unit), piece, { allowance, output: OUTPUT });
        expect([...refusals(text, "tnc640"), ...refusals(text, "tnc7")]).toEqual([]);
        const second = blankOf(text);
        expect(differences(flippedPiece(piece, allowance), second, unit)).toEqual([]);
        const again = blankOf(secondSide(parse(text), second, { allowance: 0, output: OUTPUT }));
        expect(differences(flippedPiece(flippedPiece(piece, 0), 0), again, unit)).toEqual([]);
      }
    }),
    { numRuns: 60 },
  );
});

const programs = Object.entries(
  import.meta.glob<string>(["../programs/*.h", "../shop/*.h"], { query: "?raw", import: "default", eager: true }),
);

test.each(programs)("the stock of %s is the blank of the next clamping", (_, text) => {
  const program = parse(text),
    done = run(program, { tools: shippedTools, rapid: 10_000 });
  const stock = done.blank.length > 0 ? simulate(done).final : [];
  for (const piece of pieces(stock)) {
    const second = secondSide(program, piece, { allowance: 0, output: OUTPUT });
    expect([...refusals(second, "tnc640"), ...refusals(second, "tnc7")]).toEqual([]);
    expect(differences(flippedPiece(piece, 0), blankOf(second), / INCH$/m.test(text) ? "INCH" : "MM")).toEqual([]);
  }
});
