// Must not compile: see NegativeCompileTest.cpp.
#include "ShaderPermutation.h"

class FUsed : SHADER_PERMUTATION_BOOL("USED");
class FForeign : SHADER_PERMUTATION_BOOL("FOREIGN");

void SetForeign(TShaderPermutationDomain<FUsed>& Domain)
{
	Domain.Set<FForeign>(true);
}
