import type { DocumentId } from "./steps.ts";

/** The settings of this device. */
export const SETTINGS: DocumentId = "settings";
/** The list of works: a work deleted, renamed, duplicated or restored. */
export const WORKS: DocumentId = "works";
/** Progress, exercises and results of the course. */
export const COURSE: DocumentId = "course";
/** The finished parts of this device. */
export const PARTS: DocumentId = "parts";

const WORK = "work ";
/** The document of a work, by the key it is saved under; null for one that is not saved. */
export const documentOfWork = (work: string | null): DocumentId => WORK + (work ?? "");
/** The key of the work that a document is; null for other documents. */
export const workOfDocument = (document: DocumentId): string | null =>
  document.startsWith(WORK) ? document.slice(WORK.length) : null;
