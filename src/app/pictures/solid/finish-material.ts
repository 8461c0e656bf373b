import { Color, MeshPhongMaterial } from "three";
import { TEXTURE_CODES } from "../../../view/solid/finish.ts";
import { SCALE_TONES } from "../../../view/load/scale.ts";
import { FEED_LINES } from "../../../view/material/lines.ts";
import { TONED } from "./tone.ts";

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
/** Strength of feed marks. */
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

const list = (of: (gloss: Gloss) => number) => TEXTURE_CODES.map((name) => of(GLOSS[`${name}`]).toFixed(3)).join(", ");

/** Steel as it was made: raw, rough with the marks of its feed at their pitch, threaded, or finished. */
export interface FinishedSteel {
  readonly material: MeshPhongMaterial;
  /** `tones`: of the scale, from lowest to highest. */
  readonly colours: (of: SteelColours & { readonly line: string; readonly tones: readonly string[] }) => void;
}

/** The vertex attribute of a surface's look. */
export const LOOKS_ATTRIBUTE = "looks";

/** A Phong material whose shine is set per vertex. */
export function finishedSteel(): FinishedSteel {
  const material = new MeshPhongMaterial({
    shininess: 28,
    specular: 0x2a2a2a,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
  });
  const [mark, dark, light] = [{ value: new Color() }, { value: new Color() }, { value: new Color() }];
  const tones = { value: Array.from({ length: SCALE_TONES }, () => new Color()) };
  material.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, { mark, dark, light, tones });
    shader.vertexShader = shader.vertexShader.replace(
      "void main() {",
      `
      attribute vec2 ${LOOKS_ATTRIBUTE};
      varying vec2 look;
      void main() {
        look = ${LOOKS_ATTRIBUTE};`,
    );
    shader.fragmentShader = shader.fragmentShader
      .replace(
        "void main() {",
        `
      uniform vec3 mark;
      uniform vec3 dark;
      uniform vec3 light;
      uniform vec3 tones[${SCALE_TONES}];
      varying vec2 look;
      const float GROUND[${TEXTURE_CODES.length}] = float[](${list(({ ground }) => ground)});
      const float SHINE[${TEXTURE_CODES.length}] = float[](${list(({ shine }) => shine)});
      void main() {
        int made = int(look.x + 0.5) % ${TEXTURE_CODES.length};
        int told = int(look.x + 0.5) / ${TEXTURE_CODES.length};`,
      )
      .replace(
        "#include <color_fragment>",
        `
        diffuseColor.rgb = mix(diffuseColor.rgb, GROUND[made] < 0.0 ? dark : light, abs(GROUND[made]));
        if (told > 0) diffuseColor.rgb = tones[told - 1];
        float turnPixel = fwidth(look.y);
        float apart = 1.0 / max(turnPixel, 0.000001);
        float fine = 1.0 - smoothstep(0.0, 1.0, abs(fract(look.y + 0.5) - 0.5) * apart);
        float strength = clamp((apart - ${FEED_LINES.none.toFixed(1)}) / ${(FEED_LINES.full - FEED_LINES.none).toFixed(1)}, 0.0, 1.0);
        diffuseColor.rgb = mix(diffuseColor.rgb, mark, ${MARK} * fine * strength * step(0.000001, turnPixel));`,
      )
      .replace(
        "#include <specularmap_fragment>",
        `float specularStrength = told > 0 ? ${TOLD_SHINE.toFixed(1)} : SHINE[made];`,
      )
      .replace(
        "#include <opaque_fragment>",
        `${TONED}
        #include <opaque_fragment>`,
      );
  };
  return {
    material,
    colours(of) {
      material.color.set(of.steel);
      mark.value.set(of.line);
      dark.value.set(of.dark);
      light.value.set(of.light);
      tones.value.forEach((tone, i) => tone.set(of.tones[i] ?? of.line));
    },
  };
}
