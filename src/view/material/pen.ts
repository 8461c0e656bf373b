/** Colours along a straight line, as a canvas makes them. */
export interface PenGradient {
  addColorStop(offset: number, colour: string): void;
}

/** The part of a canvas that a painter needs: the drawing context of a browser has all of it. */
export interface Pen {
  fillStyle: string | object;
  strokeStyle: string | object;
  lineWidth: number;
  globalAlpha: number;
  save(): void;
  restore(): void;
  /** From CSS pixels to device pixels. */
  setTransform(a: number, b: number, c: number, d: number, e: number, f: number): void;
  clearRect(x: number, y: number, width: number, height: number): void;
  fillRect(x: number, y: number, width: number, height: number): void;
  createLinearGradient(x0: number, y0: number, x1: number, y1: number): PenGradient;
  setLineDash(dashes: number[]): void;
  beginPath(): void;
  moveTo(x: number, y: number): void;
  lineTo(x: number, y: number): void;
  closePath(): void;
  rect(x: number, y: number, width: number, height: number): void;
  clip(rule?: "nonzero" | "evenodd"): void;
  fill(rule?: "nonzero" | "evenodd"): void;
  stroke(): void;
}

/** A part of the picture, CSS pixels from its top left corner. */
export interface Patch {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}
