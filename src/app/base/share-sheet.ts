/** Content for the system's share sheet. */
export interface Shareable {
  readonly name: string;
  /** Empty if it is longer than messengers accept. */
  readonly link: string;
  readonly file: () => File;
}

/** The link if it is short enough, otherwise the file. */
const dataOf = ({ name, link, file }: Shareable): ShareData =>
  link === "" ? { title: name, files: [file()] } : { title: name, url: link };

/** Whether this system has a share sheet for this content. */
export const canShare = (what: Shareable): boolean =>
  typeof navigator.share === "function" && typeof navigator.canShare === "function" && navigator.canShare(dataOf(what));

/** Opens the share sheet; cancelling it is no error. */
export async function share(what: Shareable): Promise<void> {
  try {
    await navigator.share(dataOf(what));
  } catch {
    return;
  }
}
