import { contourFrom, type ContourElement } from "../kernel/contour.ts";
import { at, type Pt } from "../kernel/point.ts";
import { rounded } from "../kernel/units.ts";
import { dice, type Draw, type Setups } from "./drawn-setup.ts";
import { radialTool } from "./recess-setups.ts";

const { mm, mostly, common, box } = dice;

/** Values that every recessing cycle has behind its limit of a plunge. */
export const plunged = (draw: Draw) => ({
  Q463: mostly(draw, 0, mm(draw, 0.5, 9)),
  Q510: draw.one(0.8, 1, mm(draw, 0.4, 1)),
  Q511: draw.one(100, draw.whole(30, 120)),
  Q462: draw.one(0, 1),
  Q211: draw.one(0, 3, mm(draw, 0.5, 4)),
  Q562: draw.one(0, 1),
});

/** What recess turning asks for and recessing does not. */
const TURNED = ["Q507", "Q508", "Q509", "Q488"];

/** Set-ups of recess turning as recessing has them. */
export const plungedSetups = (turned: Setups): Setups => (draw) => {
  const drawn = turned(draw);
  if (!drawn) return null;
  const own = Object.fromEntries(Object.entries(drawn.values).filter(([q]) => !TURNED.includes(q)));
  return { ...drawn, values: { ...own, ...plunged(draw) }, tool: { ...drawn.tool, RS: draw.one(0, 0.2, 0.4, 0.9) } };
};

/** Walls, floors, tapers and arcs over and in a part, with corners between them: how far along, and how deep at the most. */
function valleys(draw: Draw, depth: number, place: (along: number, deep: number) => Pt): { made: ContourElement[]; whole: number } {
  const count = draw.whole(3, 9);
  let [along, deep] = [0, mostly(draw, 0, mm(draw, 0, depth))];
  const made: ContourElement[] = [{ kind: "line", to: place(along, deep) }];
  for (let i = 1; i <= count; i += 1) {
    const kind = draw.one("wall", "floor", "slope", "slope");
    const [before, from] = [along, deep];
    if (kind !== "floor") deep = mm(draw, 0, depth);
    if (kind !== "wall") along = rounded(along + mm(draw, 0.6, 12));
    const chord = Math.hypot(along - before, deep - from);
    const bulge = kind === "wall" ? 0 : mostly(draw, 0, mm(draw, 0.6, 3));
    const to = place(along, deep);
    made.push(
      bulge > 0 && chord > 0.5 ? { kind: "radius", to, radius: rounded(chord * bulge), turn: draw.one("cw", "ccw") } : { kind: "line", to },
    );
    const corner = draw.one("none", "round", "chamfer");
    if (corner !== "none" && i < count) made.push({ kind: corner, size: mm(draw, 0.2, 1.5) });
  }
  return { made, whole: along };
}

/** Set-ups of the free recessing contours: in a cylinder, a bore or a face, both ways, with limits on every side. */
export const plungedContours = (transverse: boolean): Setups => (draw) => {
  const [out, way] = [transverse ? 1 : draw.one<1 | -1>(1, -1), draw.one<1 | -1>(1, -1)];
  const [r0, z0] = [mm(draw, 26, 45), mm(draw, -10, 5)];
  const { made, whole } = valleys(draw, out > 0 ? 14 : 9,
    (along, deep) =>
      transverse
        ? at(rounded(z0 - deep), rounded(r0 + (way > 0 ? along : -along / 4)))
        : at(rounded(z0 - way * along), rounded(r0 - out * deep)));
  const built = contourFrom(made);
  if (whole < 4 || built.issues.some((i) => i.severity === "error")) return null;
  const first = built.segments[0]?.from ?? at(z0, r0);
  const above = draw.one(0, mm(draw, 0, 4));
  const RS = draw.one(0, 0.2, 0.4, 0.9);
  return {
    values: {
      ...common(draw),
      ...plunged(draw),
      Q479: draw.one(0, 0, 1),
      Q480: mm(draw, 20, 100),
      Q482: mm(draw, -40, 10),
    },
    contour: built.segments,
    tool: transverse ? { T: 8, TO: 8, CUTWIDTH: draw.one(2, 3, 4), RS } : { ...radialTool(draw, out), RS },
    start: transverse ? at(z0 + above, first.r) : at(first.z, Math.max(0.5, r0 + out * above)),
    blank: transverse ? box(z0, z0 - 60, 0, 120) : box(z0 + 130, z0 - 130, r0, out > 0 ? 0 : r0 + 40),
  };
};
