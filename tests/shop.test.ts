import { describe, expect, test } from "vitest";
import { verified } from "../scripts/verify.ts";
import { refusals } from "../src/control-file/refusals.ts";
import { over, readTools } from "../src/program/tools/read-tools.ts";
import { shippedTools } from "../src/program/tools/shipped-tools.ts";
import type { Report } from "../src/report/report.ts";
import tools from "./shop/tools.json?raw";

/** The expected report of an ordinary program, besides its verdict, which is always that it is proved. */
interface ExpectedReport {
  /** Useful infos. Any other info is noise. */
  readonly infos?: readonly string[];
  /** Number of parts that the program parts off: each is reported once. */
  readonly partsOff?: number;
  /** Most residual material over the drawn contours, mm². */
  readonly left?: number;
}

const programs = import.meta.glob<string>("./shop/*.h", { query: "?raw", import: "default", eager: true });
const nameOf = (path: string) => path.replace(/^\.\/shop\/|\.h$/g, "");

/**
 * Programs as setters write them, each with manually checked paths. They test the proof on everyday programs: nobody
 * reads findings if every third program has a false one.
 */
const shop: Readonly<Record<string, ExpectedReport>> = {
  "bar-parts": { partsOff: 3 },
  boring: {},
  bush: { partsOff: 1 },
  // The insert's residue in the corners of the simple shoulders is part of their contour.
  chamfers: { infos: ["materialLeft"], left: 0.28 },
  "circlip-shaft": {},
  // Its collet is stated: nothing touches it, and the parted-off part is reported.
  "collet-ring": { partsOff: 1 },
  cone: { infos: ["airPasses"] },
  "drill-tap": {},
  "face-grooves": { infos: ["airPasses"] },
  "finish-appr": {},
  flange: {},
  "hand-facing": {},
  knob: { infos: ["airPasses"] },
  "part-off-chamfer": { partsOff: 1 },
  pulley: {},
  "second-side": {},
  shaft: {},
  "stepped-bush": {},
  "thread-fine": { infos: ["depthFromPitch"] },
  "thread-inch": { infos: ["depthFromPitch"] },
  "thread-inside": { infos: ["depthFromPitch"] },
  "thread-outside": { infos: ["depthFromPitch", "undercutDefaults", "wordsRecalled"] },
  "v-belt-pulley": { infos: ["airPasses"] },
};

const shopTools = (() => {
  const read = readTools(tools);
  if ("problem" in read) throw new Error(read.problem);
  return over({ tools: shippedTools }, read);
})();

/** The differences between a report and its expectation, in words. */
function differences(r: Report, { infos = [], partsOff = 0, left = 0 }: ExpectedReport): string[] {
  const { proof } = r;
  const stays = proof.residual.reduce((sum, each) => sum + each.area, 0);
  const parted = r.issues.filter((i) => i.code === "partedOff").length;
  const needless = r.issues.filter((i) => i.code !== "partedOff" && !(i.severity === "info" && infos.includes(i.code)));
  return [
    ...(proof.verdict === "proved" ? [] : [`verdict ${proof.verdict}`]),
    ...needless.map((i) => `${i.severity} ${i.code}, block ${i.block}: ${i.text}`),
    ...(parted === partsOff ? [] : [`${parted} pieces are parted off`]),
    ...(stays > left ? [`${stays} mm² stay`] : []),
    ...(proof.holder === "contact" ? ["holder touches"] : []),
  ];
}

describe("programs as they are written in shops", () => {
  test("each has its row, and each row its program", () => {
    expect(Object.keys(programs).map(nameOf).sort()).toEqual(Object.keys(shop).sort());
  });
  for (const [name, said] of Object.entries(shop)) {
    const text = programs[`./shop/${name}.h`] ?? "";
    test(`${name} is proved without a needless finding`, () => {
      expect(differences(verified(`${name}.h`, text, shopTools), said)).toEqual([]);
    });
    test(`${name} is a file that a control loads`, () => {
      expect(refusals(text, "tnc640")).toEqual([]);
      expect(refusals(text, "tnc7")).toEqual([]);
    });
  }
});
