import { create } from "zustand";

/** Shows a block of the open work: by its index in one of its files (null: the program that runs), and by its number. */
export type ShowBlock = (file: string | null, index: number, number: number) => void;

/** Another text of the file that is shown, with the name it is told by. */
export interface OtherText {
  readonly name: string;
  readonly text: string;
}

const nothing = { showBlock: null, against: null } as const;

/** The way to a block of the open work while that is compared with another; null while it is not. Undo does not touch it. */
export const useComparing = create<{ readonly showBlock: ShowBlock | null; readonly against: OtherText | null }>(() => nothing);

export const showComparison = (showBlock: ShowBlock, against: OtherText | null = null): void =>
  useComparing.setState({ showBlock, against });
export const hideComparison = (): void => useComparing.setState(nothing);
