/** Line icons drawn for this project, 24 units square; decorative: the name is beside the icon or in the label. */
const paths = {
  undo: "M4 9h10a6 6 0 0 1 0 12H9M4 9l5-5M4 9l5 5",
  redo: "M20 9H10a6 6 0 0 0 0 12h5M20 9l-5-5M20 9l-5 5",
  copy: "M9 9h11v11H9zM5 15H4V4h11v1",
  check: "M4 13l5 5L20 6",
  download: "M12 4v11M7 11l5 5 5-5M4 20h16",
  fold: "M9 5l7 7-7 7",
  unfold: "M15 5l-7 7 7 7",
  settings: "M4 7h9M19 7h1M4 17h1M11 17h9M16 4v6M8 14v6",
  error: "M12 3l9.5 17h-19zM12 10v5M12 17.6v.4",
  warning: "M12 3a9 9 0 1 0 0 18 9 9 0 0 0 0-18zM12 7v6M12 16.4v.4",
  info: "M12 3a9 9 0 1 0 0 18 9 9 0 0 0 0-18zM12 11v6M12 7.4v.4",
  search: "M10.5 4a6.5 6.5 0 1 0 0 13 6.5 6.5 0 0 0 0-13zM15.3 15.3L21 21",
  goTo: "M4 5h9M4 12h7M4 19h9M14 12h7M17.5 8.5L21 12l-3.5 3.5",
  foldLines: "M4 4h16M4 20h16M12 6.5v4M9 8.5l3 3 3-3M12 17.5v-4M9 15.5l3-3 3 3",
  numbers: "M10 4L8 20M16 4l-2 16M4.5 9h16M3.5 15h16",
  question: "M12 3a9 9 0 1 0 0 18 9 9 0 0 0 0-18zM9.2 9.5a2.8 2.8 0 1 1 4 2.5c-.8.4-1.2.9-1.2 2M12 17v.2",
  enlarge: "M4 9V4h5M15 4h5v5M20 15v5h-5M9 20H4v-5",
  reduce: "M9 4v5H4M15 4v5h5M15 20v-5h5M9 20v-5H4",
  up: "M6 15l6-6 6 6",
  down: "M6 9l6 6 6-6",
  back: "M19 12H5M11 6l-6 6 6 6",
  add: "M12 5v14M5 12h14",
  menu: "M4 6.5h16M4 12h16M4 17.5h16",
  home: "M4 11l8-7 8 7M6 9.5V20h4v-6h4v6h4V9.5",
  insert: "M12 2.5l6 9.5-6 9.5-6-9.5zM12 10.4a1.6 1.6 0 1 0 0 3.2 1.6 1.6 0 0 0 0-3.2z",
  close: "M6 6l12 12M18 6L6 18",
  play: "M7 4l13 8-13 8z",
  pause: "M8 5v14M16 5v14",
  raise: "M12 20V6M6 12l6-6 6 6M5 3h14",
  lower: "M12 4v14M6 12l6 6 6-6M5 21h14",
  compare: "M4 5h7v14H4zM13 5h7v14h-7zM6.5 9h2M6.5 12.5h2M15.5 9h2M15.5 16h2",
  drawing: "M3 14V9h6V5h6v5h6v4zM3 19h18M3 17v4M21 17v4",
  print: "M7 9V4h10v5M7 17H4v-8h16v8h-3M7 14h10v6H7z",
  share: "M12 15V3M8 7l4-4 4 4M5 12v8h14v-8",
  solid: "M12 3l8 4.5v9L12 21l-8-4.5v-9zM4 7.5l8 4.5 8-4.5M12 12v9",
  turn: "M4 8h15l-4-4M20 16H5l4 4",
  rename: "M4 20h4L19.5 8.5l-4-4L4 16zM13 7l4 4",
  blocks: "M5 6h2M5 12h2M5 18h2M10 6h9M10 12h9M10 18h6",
  clamp: "M3 5h6v14H3M9 8h4v3H9M9 13h4v3H9M13 9.5h8v5h-8",
  remove: "M5 7h14M10 7V4h4v3M7 7l1 13h8l1-13M10 11v5M14 11v5",
} as const;

export type IconName = keyof typeof paths;

export function Icon({ name }: { readonly name: IconName }) {
  return (
    <svg className="icon" viewBox="0 0 24 24" aria-hidden="true" focusable="false">
      <path d={paths[name]} />
    </svg>
  );
}
