/** Line icons of the lathe view, 24 units square. Decorative, since the button has the name. */
const strokes = {
  play: "M8 5l11 7-11 7z",
  pause: "M8 5v14M16 5v14",
  forward: "M7 5l9 7-9 7zM19 5v14",
  back: "M17 5l-9 7 9 7zM5 5v14",
  first: "M5 5v14M12 6l-5 6 5 6M19 6l-5 6 5 6",
  last: "M19 5v14M12 6l5 6-5 6M5 6l5 6-5 6",
  zoomIn: "M5 12h14M12 5v14",
  zoomOut: "M5 12h14",
  fit: "M4 9V4h5M15 4h5v5M20 15v5h-5M9 20H4v-5",
  target: "M4 9V4h5M15 4h5v5M20 15v5h-5M9 20H4v-5M7 15V9.5h4.5V12H17v3z",
  ruler: "M3 15L15 3l6 6L9 21zM7 11l2 2M10 8l3 3M13 5l2 2",
  which: "M3 19h6v-6h6V7h6M5.5 8.5a2.3 2.3 0 1 1 3.3 2c-.7.4-1 .8-1 1.5",
  paths: "M4 20V9a4 4 0 0 1 8 0v6a4 4 0 0 0 8 0V4",
  colours: "M12 3.5c4 4.6 6 7.6 6 10.3a6 6 0 0 1-12 0c0-2.7 2-5.7 6-10.3zM12 17a3.2 3.2 0 0 0 3.2-3.2",
  view: "M2 12c3-5 6.5-7 10-7s7 2 10 7c-3 5-6.5 7-10 7s-7-2-10-7zM12 9a3 3 0 1 0 0 6 3 3 0 0 0 0-6z",
  xUp: "M8 20V5M4 9l4-4 4 4M15 20l6-8M15 12l6 8",
  xDown: "M8 4v15M4 15l4 4 4-4M15 12l6-8M15 4l6 8",
} as const;

export type GlyphName = keyof typeof strokes;

export function Glyph({ name }: { readonly name: GlyphName }) {
  return (
    <svg className="icon" viewBox="0 0 24 24" aria-hidden="true" focusable="false">
      <path d={strokes[name]} />
    </svg>
  );
}
