/** The parts of this language, each fetched by itself. */
export const parts = import.meta.glob<Readonly<Record<string, unknown>>>("./*.ts");
