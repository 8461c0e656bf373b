/** Host names of the device itself. */
const ITSELF = /^(localhost|.+\.localhost|127(\.\d+){3}|\[::1\])$/;

/** The address of this page, without query and fragment. */
export const pageAddress = (): string => location.href.replace(/[?#].*/, "");

/** True if the address is local, so that another device cannot open a link to it. */
export function isLocalAddress(page: string): boolean {
  const { protocol, hostname } = new URL(page);
  return protocol === "file:" || ITSELF.test(hostname);
}
