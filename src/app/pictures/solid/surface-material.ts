import { Color, ShaderMaterial, Vector3, type ColorRepresentation } from "three";
import { TEXTURE_CODES } from "../../../view/solid/finish.ts";
import { SCALE_TONES } from "../../../view/load/scale.ts";
import { FEED_LINES } from "../../../view/material/lines.ts";
import { LIGHT, TONED } from "./tone.ts";

/** How a surface differs from steel: lighter or darker, −1 … 1, and its shine as a share of that of steel. */
interface Gloss {
  readonly ground: number;
  readonly shine: number;
}

/** As in the section: a finished surface is light and shiny, a rough one dull, a milled one duller. */
const GLOSS: Readonly<Record<`${(typeof TEXTURE_CODES)[number]}`, Gloss>> = {
  null: { ground: 0, shine: 1 },
  raw: { ground: -0.34, shine: 0.1 },
  rough: { ground: -0.08, shine: 0.5 },
  thread: { ground: 0, shine: 1 },
  finished: { ground: 0.3, shine: 2.4 },
};
/** How far feed marks differ from their ground, 0 … 1. */
const MARK = 0.3;
/** Shine of a surface with colour map: little, so that its colour stays that of the scale. */
const TOLD_SHINE = 0.4;

/** Page colours from which those of steel are made. */
export interface SteelColours {
  readonly steel: string;
  readonly dark: string;
  readonly light: string;
}

/** The colour of a surface in white light. */
export function groundOf(texture: `${(typeof TEXTURE_CODES)[number]}`, { steel, dark, light }: SteelColours): Color {
  const { ground } = GLOSS[texture];
  return new Color(steel).lerp(new Color(ground < 0 ? dark : light), Math.abs(ground));
}

const glsl = (n: number) => n.toFixed(4);
const TO_LIGHT = new Vector3(...LIGHT.from).normalize().toArray().map(glsl).join(", ");

/** The vertex attribute of a surface's look; surfaces without one have the first ground. */
export const LOOKS_ATTRIBUTE = "looks";

/**
 * Colours are made at the corners: without a graphics card light at every pixel takes longer than all else, and where
 * surfaces are round their corners are close. The light is that of Blinn and Phong.
 */
const VERTEX = `
uniform vec3 grounds[${TEXTURE_CODES.length}];
uniform float shines[${TEXTURE_CODES.length}];
uniform vec3 tones[${SCALE_TONES}];
uniform vec3 mark;
uniform vec3 specular;
uniform float shininess;
attribute vec2 ${LOOKS_ATTRIBUTE};
varying vec3 plain;
varying vec3 marked;
varying float turn;
vec3 shown(vec3 light) {
  ${TONED}
  return mix(12.92 * light, 1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, light));
}
void main() {
  int made = int(${LOOKS_ATTRIBUTE}.x + 0.5) % ${TEXTURE_CODES.length};
  int told = int(${LOOKS_ATTRIBUTE}.x + 0.5) / ${TEXTURE_CODES.length};
  vec3 ground = told > 0 ? tones[told - 1] : grounds[made];
  float shine = told > 0 ? ${glsl(TOLD_SHINE)} : shines[made];
  vec4 place = modelViewMatrix * vec4(position, 1.0);
  vec3 away = normalize(normalMatrix * normal);
  vec3 toLight = vec3(${TO_LIGHT});
  float falling = ${glsl(LIGHT.key)} * max(dot(away, toLight), 0.0);
  float mirrored = max(dot(away, normalize(toLight - normalize(place.xyz))), 0.0);
  vec3 glint = falling * shine * specular * (0.125 * shininess + 0.25) * pow(mirrored, shininess);
  float received = falling + ${glsl(LIGHT.around)};
  plain = shown(received * ground + glint);
  marked = shown(received * mix(ground, mark, ${glsl(MARK)}) + glint);
  turn = ${LOOKS_ATTRIBUTE}.y;
  gl_Position = projectionMatrix * place;
}`;

const FRAGMENT = `
varying vec3 plain;
varying vec3 marked;
varying float turn;
void main() {
  float turnPixel = fwidth(turn);
  float apart = 1.0 / max(turnPixel, 0.000001);
  float fine = 1.0 - smoothstep(0.0, 1.0, abs(fract(turn + 0.5) - 0.5) * apart);
  float strength = clamp((apart - ${glsl(FEED_LINES.none)}) / ${glsl(FEED_LINES.full - FEED_LINES.none)}, 0.0, 1.0);
  gl_FragColor = vec4(mix(plain, marked, fine * strength * step(0.000001, turnPixel)), 1.0);
}`;

/** A surface slightly behind the lines on it. */
export interface Surface {
  readonly material: ShaderMaterial;
  /** The colour of a surface without a look. */
  readonly color: Color;
  /** Sets those of steel; `tones`: of the scale, from lowest to highest. */
  readonly setSteel: (of: SteelColours & { readonly line: string; readonly tones: readonly string[] }) => void;
}

/** A surface with the shine of its material. */
export function surface(shininess: number, specular: ColorRepresentation): Surface {
  const colours = (count: number) => Array.from({ length: count }, () => new Color());
  const [grounds, tones, [mark = new Color()]] = [colours(TEXTURE_CODES.length), colours(SCALE_TONES), colours(1)];
  const uniforms = {
    grounds: { value: grounds },
    shines: { value: TEXTURE_CODES.map((name) => GLOSS[`${name}`].shine) },
    tones: { value: tones },
    mark: { value: mark },
    specular: { value: new Color(specular) },
    shininess: { value: shininess },
  };
  return {
    material: new ShaderMaterial({
      uniforms,
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      polygonOffset: true,
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 1,
    }),
    color: grounds[0] ?? mark,
    setSteel(of) {
      mark.set(of.line);
      TEXTURE_CODES.forEach((name, i) => grounds[i]?.copy(groundOf(`${name}`, of)));
      tones.forEach((tone, i) => tone.set(of.tones[i] ?? of.line));
    },
  };
}
