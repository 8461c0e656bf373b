/**
 * The shape of a set of texts: same keys and arguments, any words. English is written first; the other languages must
 * match its shape.
 */
export type Shape<T> = T extends string
  ? string
  : T extends (...values: infer V) => string
    ? (...values: V) => string
    : T extends readonly (infer E)[]
      ? readonly Shape<E>[]
      : { readonly [K in keyof T]: Shape<T[K]> };
