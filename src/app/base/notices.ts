import { create } from "zustand";

/** Notices above the open work, until somebody dismisses them. */
export type Notice =
  | "notKept"
  | "storageFull"
  | "storageSilent"
  | "newerWorks"
  | "newerData"
  | "rowsAside"
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

/** Shows a notice, once. */
export const notice = (which: Notice): void =>
  useNotices.setState(({ notices }) => (notices.includes(which) ? { notices } : { notices: [...notices, which] }));

/** Removes a notice. */
export const withdraw = (which: Notice): void =>
  useNotices.setState(({ notices }) => ({ notices: notices.filter((n) => n !== which) }));
