/**
 * Other devices than a desktop, for `test.use`: as projects of their own they would start all workers and browsers again.
 */
export const TABLET = { viewport: { width: 1024, height: 768 }, hasTouch: true };
export const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
