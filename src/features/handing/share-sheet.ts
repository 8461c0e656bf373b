/** What the system's share sheet can be given. */
export interface Shareable {
  readonly name: string;
  /** Empty where it is longer than messengers take. */
  readonly link: string;
  readonly archive: string;
  readonly bytes: () => Uint8Array<ArrayBuffer>;
}

/** The link where it is short enough to arrive, otherwise the file. */
const dataOf = ({ name, link, archive, bytes }: Shareable): ShareData =>
  link === ""
    ? { title: name, files: [new File([bytes()], archive, { type: "application/zip" })] }
    : { title: name, url: link };

/** Whether this system has a share sheet that takes it. */
export const canShare = (what: Shareable): boolean =>
  typeof navigator.share === "function" && typeof navigator.canShare === "function" && navigator.canShare(dataOf(what));

/** Opens the share sheet; one that is closed again has shared nothing, which needs no word. */
export async function share(what: Shareable): Promise<void> {
  try {
    await navigator.share(dataOf(what));
  } catch {
    return;
  }
}
