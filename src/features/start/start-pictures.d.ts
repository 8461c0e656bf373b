/* eslint-disable @typescript-eslint/consistent-type-imports -- A declared module cannot import from a file beside it. */
/** Made by the build out of the programs that ship with the page (scripts/start-pictures.ts). */
declare module "virtual:start-pictures" {
  export const pictures: import("./pictures.ts").StartPictures;
}
