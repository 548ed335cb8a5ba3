/* A library without a user-material subroutine, for tests. */

const int sandglass_umat_none = 0;
