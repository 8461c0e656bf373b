/** Bytes in words: 12.4 kB, 3.1 MB. */
export function sizeWords(bytes: number, language: string): string {
  const [by, unit] =
    bytes < 1e6
      ? ([1e3, "kilobyte"] as const)
      : bytes < 1e9
        ? ([1e6, "megabyte"] as const)
        : ([1e9, "gigabyte"] as const);
  const of = bytes / by;
  return new Intl.NumberFormat(language, { style: "unit", unit, maximumFractionDigits: of < 10 ? 1 : 0 }).format(
    Math.max(of, 0.1),
  );
}
