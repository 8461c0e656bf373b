const isPlain = (a: unknown): a is Readonly<Record<string, unknown>> => {
  const kind: unknown = typeof a === "object" && a !== null ? Object.getPrototypeOf(a) : null;
  return kind === Object.prototype || kind === Array.prototype;
};

/** Whether two pieces of plain data are equal, in any order of their members. Shared objects are not compared. */
export function isSameData(a: unknown, b: unknown): boolean {
  if (a === b) return true;
  if (!isPlain(a) || !isPlain(b) || Array.isArray(a) !== Array.isArray(b)) return false;
  const names = Object.keys(a);
  return names.length === Object.keys(b).length && names.every((name) => name in b && isSameData(a[name], b[name]));
}
