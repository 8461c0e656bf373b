import { create } from "zustand";

/** What the page says above what is open, until somebody puts it away. */
export type Notice =
  | "notKept"
  | "storageFull"
  | "newerWorks"
  | "copyOfOtherTab"
  | "engineFailed"
  | "linkDamaged"
  | "linkTooLarge"
  | "linkNewer"
  | "fileTooLarge"
  | "fileUnreadable"
  | "mainUnsure"
  | "isoRead"
  | "filesLeftOut"
  | "toolsDamaged"
  | "toolsNotKept"
  | "ownDamaged"
  | "ownNotKept"
  | "workNotHere";

export const useNotices = create<{ readonly notices: readonly Notice[] }>(() => ({ notices: [] }));

/** Says something, once. */
export const notice = (which: Notice): void =>
  useNotices.setState(({ notices }) => (notices.includes(which) ? { notices } : { notices: [...notices, which] }));

/** Puts away what was said. */
export const withdraw = (which: Notice): void =>
  useNotices.setState(({ notices }) => ({ notices: notices.filter((n) => n !== which) }));
