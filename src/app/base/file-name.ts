/** The name of a program's file, from its first block. */
export const fileNameOf = (text: string): string =>
  `${/BEGIN PGM (\S+)/.exec(text)?.[1]?.replace(/[\\/:*?"<>|]/g, "_") ?? "PROGRAM"}.h`;
