import { Color, ShaderMaterial, type ColorRepresentation } from "three";

/** A section face as on paper: plain background with fine lines at 45°, spaced on the screen as in the drawing. */
export interface Hatched {
  readonly material: ShaderMaterial;
  /** Colours of background and lines. */
  readonly colours: (ground: ColorRepresentation, line: ColorRepresentation) => void;
  /** From one line to the next, mm. */
  readonly pitch: (mm: number) => void;
}

const VERTEX = `
varying vec2 place;
void main() {
  place = vec2(position.z, position.x + position.y);
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

const FRAGMENT = `
uniform vec3 ground;
uniform vec3 line;
uniform float pitch;
uniform float lean;
uniform float weight;
varying vec2 place;
void main() {
  float across = (place.x * lean + place.y) * 0.70710678 / pitch;
  float pixel = max(fwidth(across), 0.000001);
  float away = abs(fract(across) - 0.5) / pixel;
  float fine = 1.0 - smoothstep(weight * 0.5 - 0.5, weight * 0.5 + 0.5, away);
  float drawn = mix(fine, 0.2, smoothstep(0.25, 0.5, pixel));
  gl_FragColor = vec4(mix(ground, line, drawn), 1.0);
  #include <colorspace_fragment>
}`;

/** `lean`: 1 falls to the right, −1 rises. `weight`: line width, pixels. */
export function hatched(lean: 1 | -1, weight: number): Hatched {
  const [ground, line, pitch] = [{ value: new Color() }, { value: new Color() }, { value: 1 }];
  const uniforms = { ground, line, pitch, lean: { value: lean }, weight: { value: weight } };
  const material = new ShaderMaterial({
    uniforms,
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
  });
  return {
    material,
    colours(under, over) {
      ground.value.set(under);
      line.value.set(over);
    },
    pitch(mm) {
      pitch.value = mm;
    },
  };
}
