/** Names by which a device calls itself. */
const ITSELF = /^(localhost|.+\.localhost|127(\.\d+){3}|\[::1\])$/;

/**
 * True where a page of this address is there on this very device only, so that another one cannot open a link to it.
 */
export function isHereOnly(page: string): boolean {
  const { protocol, hostname } = new URL(page);
  return protocol === "file:" || ITSELF.test(hostname);
}
