import type { Cycle } from "../../src/cycles/define.ts";
import type { Plan } from "../../src/kernel/plan/plan.ts";
import { areaOf as polygonArea } from "../../src/kernel/area/area.ts";
import { difference, intersection, offset } from "../../src/kernel/area/clip.ts";
import { areaOutside } from "../../src/kernel/area/real-area.ts";
import { at, type Segment } from "../../src/kernel/geometry/point.ts";
import { cutEnds } from "../../src/sim/work-holding.ts";
import {
  areaOf,
  beyondGrown,
  common,
  each,
  filled,
  grown,
  without,
  withoutCrumbs,
  type Field,
  type Grid,
} from "../judge/field.ts";
import { connectedToRear } from "../judge/clamped.ts";
import type { P } from "../judge/insert.ts";
import { judge, sumOf, THIN, type Verdict } from "../judge/judge.ts";
import type { Finding, Situation } from "./situation.ts";
import { isStartInMaterial, stepsOf } from "./worked-plans.ts";
import { looseOf, partOf, WIDTH, worked, type Worked } from "./worked.ts";

/*
 * Laws of every set-up after its moves have cut the stock, judged twice: by src/sim with polygons and by the columns of
 * tests/judge. Finishing alone (Q215 = 2, 3) is cut after the roughing of the same values.
 */

/** Smaller areas are the chords of two curves that touch, mm². */
const REAL = 0.02;
/** Residue of less than 0.01 mm² in one piece is not reported; the resolution of columns is no better, mm². */
const CRUMB = 0.012;

export type CutLaw = (w: Worked) => Finding;

const mm2 = (n: number) => `${n.toFixed(3)} mm²`;
const most = (w: Worked, of: (v: Verdict) => number) => Math.max(...w.verdicts.map(of));
/** The area of one field outside another and its tolerance zone, mm². */
const beyond = (g: Grid, a: Field, b: Field) => areaOf(g, beyondGrown(a, b, THIN));

/** The finished part is never cut, from any start point. */
const partStaysWhole: CutLaw = (w) => {
  const [ours, theirs] = [most(w, (v) => sumOf(v, "gouge")), w.simulation.proof.gouge];
  return ours > REAL || theirs > REAL ? `gouge ${mm2(theirs)}, by columns ${mm2(ours)}` : null;
};

/** Groups whose paths do not depend on the blank. */
const NO_BLANK: readonly string[] = ["longitudinal", "transverse", "recessTurning", "recessing"];
/**
 * A path does not depend on BLK FORM: a blank that is higher than the start point, or beside the area, is ignored.
 * Where the start point is below the contour, part of the area is higher than the start point.
 */
const isBlankBeside = ({ cycle, situation: { blank }, plans: [plan] }: Worked) =>
  NO_BLANK.includes(cycle.group) &&
  plan !== undefined &&
  (plan.issues.some((i) => i.code === "startBelowContour") || areaOutside(blank, [plan.area, plan.part]) > REAL);

/**
 * Rapids touch nothing, unless the tool was in material at the call. Finishing alone is excepted: it does not know the
 * steps that roughing has left.
 */
const rapidsAreFree: CutLaw = (w) => {
  if (w.plans.length > 1 || w.verdicts.some((v) => v.inside) || isBlankBeside(w)) return null;
  const [ours, theirs] = [most(w, (v) => sumOf(v, "rapid")), w.simulation.proof.rapidInStock];
  return ours > REAL || theirs > REAL ? `rapid in stock ${mm2(theirs)}, by columns ${mm2(ours)}` : null;
};

/**
 * Both simulations leave the same stock, except for one column's width and areas thinner than THIN along z or along r:
 * where a nose only touches a surface, an error of half a micrometre in depth is hundredths in width.
 */
const judgesAgreeOnStock: CutLaw = (w) => {
  const least = (of: (v: Verdict) => number) => Math.min(...w.verdicts.map(of));
  const standing = [...w.simulation.final, ...looseOf(w)];
  const more = least(({ grid, final }) => beyond(grid, final, filled(grid, standing)));
  const less = least(({ grid, final }) => beyond(grid, filled(grid, w.simulation.final), final));
  if (more <= REAL && less <= REAL) return null;
  return `the columns keep ${mm2(more)} more and ${mm2(less)} less than the polygons`;
};

/** Pieces connected by less than this, mm, or smaller than this, mm², are judged by neither. */
const HANGS = 0.05;
/** A rear end has at least this length and height, mm. */
const CLAMPED = 1;
const PIECE = 0.1;

/** Material that is no longer connected to the rear end has left the stock, and nothing else has. */
const judgesAgreeOnLoose: CutLaw = (w) => {
  if (w.plans.length > 1) return null;
  const rear = Math.min(...w.situation.blank.flat().map(({ z }) => z));
  const least = (of: (v: Verdict) => number) => Math.min(...w.verdicts.map(of));
  const held = least(({ grid, final }) =>
    areaOf(grid, each(connectedToRear(grid, final, rear - WIDTH, HANGS), filled(grid, looseOf(w)), common)),
  );
  // Where a cut has removed the clamped end, or left a point of it, the holding of the rest is unknown.
  if (w.verdicts.every(({ grid, final }) => areaOf(grid, connectedToRear(grid, final, rear, -HANGS)) === 0))
    return null;
  const clamped = [at(rear, 0), at(rear + CLAMPED, 0), at(rear + CLAMPED, 1e4), at(rear, 1e4)];
  if (
    Math.max(
      0,
      ...intersection(w.simulation.final, [clamped])
        .flat()
        .map(({ r }) => r),
    ) < CLAMPED
  )
    return null;
  if (held > PIECE) return `${mm2(held)} that hang together with the rear end have left the stock`;
  const loose = least(({ grid, final }) =>
    beyond(
      grid,
      withoutCrumbs(grid, each(final, connectedToRear(grid, final, rear, -HANGS), without), PIECE),
      filled(grid, looseOf(w)),
    ),
  );
  return loose > PIECE ? `${mm2(loose)} that hang on nothing are still there` : null;
};

/** The verdicts of columns that drop loose pieces as cuts end: a move through a former piece meets nothing. */
function verdictsWithout({ situation, plans, simulation, verdicts }: Worked): readonly Verdict[] {
  if (simulation.proof.loose.length === 0) return verdicts;
  const steps = stepsOf(plans, situation);
  const ends = (motion: number) => cutEnds(steps, motion + 1);
  return verdicts.map(({ grid }) => judge(situation.blank, steps, partOf(plans), grid, ends));
}

/**
 * A fault that one judge sees well above its resolution is also seen by the other, unless that one has reported a limit
 * of its search.
 */
const judgesAgreeOnFaults: CutLaw = (w) => {
  const clear = 0.2;
  const { gouge, rapidInStock, uncheckedFrom } = w.simulation.proof;
  if (uncheckedFrom) return null;
  const seen = verdictsWithout(w);
  const [g, r] = (["gouge", "rapid"] as const).map((kind) => Math.max(...seen.map((v) => sumOf(v, kind)))) as [
    number,
    number,
  ];
  if (g > clear && !(gouge > 0)) return `only the columns see a gouge of ${mm2(g)}`;
  if (r > clear && !(rapidInStock > 0)) return `only the columns see a rapid in stock of ${mm2(r)}`;
  return null;
};

/**
 * The material above the contour, or above the crest of a thread, is exactly the residue that the simulation reports.
 */
const judgesAgreeOnResidue: CutLaw = (w) => {
  const area = w.plans.at(-1)?.area ?? [];
  const above = w.plans.at(-1)?.thread?.above;
  if (area.length < 3 || w.plans.length > 1 || w.plans[0]?.moves.length === 0) return null;
  // A loose piece has no place, although the columns keep it where it was.
  const rings = [...w.simulation.proof.residual.map((r) => r.ring), ...looseOf(w)];
  for (const { grid, final } of w.verdicts) {
    const left = each(final, filled(grid, above ? [area, above] : [area], true), (a, b) => without(a, without(a, b)));
    // Areas below the simulation's thickness or size limit are ignored on both sides.
    const shown = withoutCrumbs(grid, thickOf(left), CRUMB);
    const thick = areaOf(grid, each(shown, grown(filled(grid, rings), 0.02), without));
    if (thick > 0.05) return `columns along ${grid.along} see residue of ${mm2(thick)} that is not reported`;
    // A strip thinner than two columns fills one of them or none.
    const wide = w.simulation.proof.residual.filter((r) => r.thickness > 2 * WIDTH).map((r) => r.ring);
    const reported = beyond(grid, filled(grid, wide), left);
    if (reported > 0.05) return `reported residue of ${mm2(reported)} is not there`;
  }
  return null;
};
/** A field without areas thinner than two columns or 0.02 mm. */
const thickOf = (f: Field): Field =>
  f.map((column, i) => {
    const near = [f[i - 1] ?? [], f[i + 1] ?? []];
    const core = near.reduce((a, b) => without(a, without(a, b)), [...column]);
    return core.flatMap((n, k) =>
      k % 2 === 0 && (core[k + 1] as number) - n > 0.02 ? [n, core[k + 1] as number] : [],
    );
  });

/** Roughing and finishing leave nothing that the tool could reach; a tool that does not fit in is excepted. */
const nothingReachableStays: CutLaw = ({ plans: [plan], situation: { values }, simulation }) => {
  if (!plan || values["Q215"] !== 0 || values["Q479"] === 1 || plan.passes === 0 || isStartInMaterial(plan))
    return null;
  if (plan.issues.some((i) => i.code === "recessNarrowerThanTool")) return null;
  const left = simulation.proof.residual.find((r) => r.reason === "oversize" && r.area > 0.05);
  return left ? `${mm2(left.area)} stay that the tool could reach` : null;
};

/**
 * Roughing alone keeps the oversize: the part grown by it is not cut. A rectangle contains the part shifted to each of
 * its corners. An insert whose start point is in the stock cuts there anyway, which is reported.
 */
const oversizeStays: CutLaw = (w) => {
  const {
    plans: [plan],
    situation: { values, blank },
    simulation,
  } = w;
  if (!plan || values["Q215"] !== 1 || plan.part.length === 0 || isStartInMaterial(plan)) return null;
  if (simulation.proof.operations[0]?.startInMaterial) return null;
  const cut = difference(blank, [...simulation.final, ...looseOf(w)]);
  const [dz, dr] = [values["Q484"] ?? 0, (values["Q483"] ?? 0) / 2];
  // Beyond the axis there is no part and no oversize.
  const far = 1e4;
  const solid = intersection([plan.part], [[at(-far, 0), at(far, 0), at(far, far), at(-far, far)]]);
  for (const [z, r] of [
    [dz, 0],
    [-dz, 0],
    [0, dr],
    [0, -dr],
  ] as const) {
    const moved = offset(
      solid.map((ring) => ring.map((p) => at(p.z + z, p.r + r))),
      -0.004,
    );
    const taken = polygonArea(intersection(intersection(cut, moved), offset([plan.area], -0.004)));
    if (taken > REAL) return `${mm2(taken)} of the oversize are cut`;
  }
  return null;
};

/**
 * Material cut beyond a machining limit, deeper than `NEWS`, is reported at the limit, and reported material was cut.
 * Material cut by rapids is reported separately.
 */
const limitsHoldOrAreReported: CutLaw = (w) => {
  const { values, start } = w.situation;
  const far = 1000;
  const [x, z] = [(values["Q480"] ?? 0) / 2, values["Q482"] ?? 0];
  // A start point on a limit is on neither side of the limit.
  if (values["Q479"] !== 1 || start.r === x || start.z === z) return null;
  const [xWay, zWay] = [start.r >= x ? -1 : 1, start.z >= z ? -1 : 1];
  const zones: readonly (readonly [string, (from: number) => P[]])[] = [
    ["Q480", (from) => across("z", -far, far, x + xWay * from, xWay * far)],
    ["Q482", (from) => across("r", -far, far, z + zWay * from, zWay * far)],
  ];
  const told = (at: string) =>
    w.simulation.proof.operations
      .flatMap((o) => o.behindLimits)
      .reduce((sum, b) => (b.limit.at === at ? sum + b.area : sum), 0);
  for (const [at, zone] of zones) {
    const taken = w.verdicts.map(({ grid, initial, final }) => {
      const [news, behindIt] = [filled(grid, [zone(REPORTED_FROM)], true), filled(grid, [zone(0)], true)];
      return [
        beyond(grid, each(initial, news, common), final),
        areaOf(grid, each(each(initial, final, without), behindIt, common)),
      ];
    });
    const [surely, perhaps] = [
      Math.min(...taken.map(([thick]) => thick ?? 0)),
      Math.max(...taken.map(([, all]) => all ?? 0)),
    ];
    const byRapids = most(w, (v) => sumOf(v, "rapid"));
    if (surely > LIMIT + byRapids && told(at) === 0)
      return `${mm2(surely)} are taken behind ${at}, and nothing says so`;
    if (told(at) > perhaps + LIMIT) return `${mm2(told(at))} are told behind ${at}, ${mm2(perhaps)} were taken`;
  }
  return null;
};
/** Cuts are reported from this depth beyond a limit, mm (decision 0034). */
const REPORTED_FROM = 0.1;
/** Only one judge sees a strip one column wide along a limit, mm². */
const LIMIT = 0.2;
/** A strip: from a to b along one axis, from c to d along the other. */
const across = (along: "z" | "r", a: number, b: number, c: number, d: number): P[] =>
  [
    [a, c],
    [b, c],
    [b, d],
    [a, d],
  ].map(([p = 0, q = 0]) => (along === "z" ? { z: p, r: q } : { z: q, r: p }));

/** A pip on the axis of a face: negligible area, mm², and the radius and height of the searched zone, mm. */
const [PIP, NEAR] = [0.01, 0.3];

/**
 * A face that ends on the axis or beyond it is clean: no pip is left. Residue of a sloping edge farther out is
 * excepted.
 */
const facesAreClean: CutLaw = ({ plans, simulation, situation: { values } }) => {
  const plan = plans.at(-1) as Plan;
  const isFinished = (values["Q215"] ?? 0) === 0 || values["Q215"] === 2;
  const face = plan.contour.find(
    ({ kind, from, to }) => kind === "line" && Math.abs(from.z - to.z) < PIP && Math.min(from.r, to.r) <= 0,
  );
  if (!face || !isFinished || plan.moves.length === 0 || values["Q479"] === 1 || values["Q487"] === 0) return null;
  if (plan.openSide.r < 0 || plan.issues.some((i) => i.code === "angleNotFollowed")) return null;
  // A contour element beyond the axis keeps the nose from facing the axis.
  if (plan.contour.some(({ from, to }) => Math.max(from.r, to.r) < 0)) return null;
  const out =
    plan.openSide.z || (plan.contour[0] === face ? Math.sign(face.from.z - (plan.contour.at(-1) as Segment).to.z) : 1);
  const [z0, z1] = [face.from.z, face.from.z + out * NEAR].sort((a, b) => a - b) as [number, number];
  const pip = intersection(intersection(simulation.final, [plan.area]), [
    [at(z0, 0), at(z1, 0), at(z1, NEAR), at(z0, NEAR)],
  ]);
  return polygonArea(pip) > PIP ? `a pip of ${mm2(polygonArea(pip))} stays on the axis` : null;
};

/** No roughing cut of a recess turned between its walls is deeper than its infeed. */
const infeedIsKept: CutLaw = (w) => {
  const [plan] = w.plans;
  if (w.cycle.group !== "recessTurning" || w.cycle.contour !== "own" || !plan || w.plans.length > 1) return null;
  const operation = w.simulation.proof.operations[0];
  if (
    plan.issues.some((i) => i.severity === "error") ||
    isStartInMaterial(plan) ||
    isBlankBeside(w) ||
    operation?.startInMaterial ||
    !operation?.deepest
  )
    return null;
  const { depth, allowed } = operation.deepest;
  return depth > allowed + UNREPORTED_EXCESS ? `a cut of ${depth.toFixed(3)} mm where ${allowed} are allowed` : null;
};
/** Smaller excess is not reported, mm. */
const UNREPORTED_EXCESS = 0.05;

/** By name, so that a stored case can state the broken laws. */
export const cutLaws: Readonly<Record<string, CutLaw>> = {
  partStaysWhole,
  rapidsAreFree,
  judgesAgreeOnStock,
  judgesAgreeOnLoose,
  judgesAgreeOnFaults,
  judgesAgreeOnResidue,
  nothingReachableStays,
  oversizeStays,
  limitsHoldOrAreTold: limitsHoldOrAreReported,
  facesAreClean,

  infeedIsKept,
};

/** Every law that a situation breaks, with its message. */
export function brokenBy(cycle: Cycle, situation: Situation, laws: readonly string[] = Object.keys(cutLaws)): string[] {
  const w = worked(cycle, situation);
  return laws.flatMap((name) => {
    const said = cutLaws[name]?.(w) ?? null;
    return said === null ? [] : [`${name}: ${said}`];
  });
}
