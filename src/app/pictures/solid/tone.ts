import { Color } from "three";

/**
 * One light over the operator's left shoulder (along these axes of the eye: right, up, towards it), and ambient light:
 * a face square to the eye has about its colour, one square to the light is a quarter brighter.
 */
export const LIGHT = { from: [-0.15, 0.5, 1], key: 0.69, around: 0.56 } as const;

/**
 * Most light (linear, 1 is white) that a surface sends to the eye, and the level from which it approaches that ever more
 * slowly.
 */
const TONE = { knee: 0.6, most: 0.82 } as const;
const SPAN = TONE.most - TONE.knee;

/** The displayed light for the light of a surface: never as bright as a white page. Linear, 1 is white. */
export const toned = (light: number): number =>
  light <= TONE.knee ? light : TONE.knee + SPAN * (1 - Math.exp((TONE.knee - light) / SPAN));

/** The same as a shader: tones the brightest channel and keeps the hue. */
export const TONED = `
  float brightest = max(light.r, max(light.g, light.b));
  if (brightest > ${TONE.knee.toFixed(3)}) {
    light *= (${TONE.knee.toFixed(3)} + ${SPAN.toFixed(3)} * (1.0 - exp((${TONE.knee.toFixed(3)} - brightest) / ${SPAN.toFixed(
      3,
    )}))) / brightest;
  }`;

/** Page colours from which those of the chuck are made. */
export interface ChuckColours {
  readonly chuck: string;
  readonly chuckDark: string;
  readonly steelLight: string;
}

/** How much darker the body is than the chuck of the drawing, and how much lighter its jaws, 0 … 1. */
const APART = { body: 0.3, jaw: 0.2 } as const;

/** Body and jaws of the chuck: darker and lighter than raw steel, so that all three differ without shading. */
export const chuckTones = ({
  chuck,
  chuckDark,
  steelLight,
}: ChuckColours): { readonly chuck: Color; readonly jaw: Color } => ({
  chuck: new Color(chuck).lerp(new Color(chuckDark), APART.body),
  jaw: new Color(chuck).lerp(new Color(steelLight), APART.jaw),
});
