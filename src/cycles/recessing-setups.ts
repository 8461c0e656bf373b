import { dice, type Draw, type Setups } from "./random-setup.ts";

const { mm, mostly } = dice;

/** Values of every recessing cycle after its limit of a plunge. */
const plunged = (draw: Draw) => ({
  Q463: mostly(draw, 0, mm(draw, 0.5, 9)),
  Q510: draw.one(0.8, 1, mm(draw, 0.4, 1)),
  Q511: draw.one(100, draw.whole(30, 120)),
  Q462: draw.one(0, 1),
  Q211: draw.one(0, 3, mm(draw, 0.5, 4)),
  Q562: draw.one(0, 1),
});

/** Parameters that recess turning has and recessing does not. */
const TURNED = ["Q507", "Q508", "Q509", "Q488", "Q499"];

/** Set-ups of recess turning, converted to recessing. */
export const plungedSetups =
  (turned: Setups): Setups =>
  (draw) => {
    const drawn = turned(draw);
    if (!drawn) return null;
    const own = Object.fromEntries(Object.entries(drawn.values).filter(([q]) => !TURNED.includes(q)));
    return { ...drawn, values: { ...own, ...plunged(draw) }, tool: { ...drawn.tool, RS: draw.one(0, 0.2, 0.4, 0.9) } };
  };
