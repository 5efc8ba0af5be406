// Registration of the test shaders, with and without semicolons, also in an anonymous namespace.
#include "ShaderTypes.h"

IMPLEMENT_GLOBAL_SHADER(FTestTintCS, "/DrydockTest/Tint.usf", "TintCS", SF_Compute);
IMPLEMENT_GLOBAL_SHADER(FTestMisspelledPS, "/DrydockTest/Misspelled.usf", "MisspelledPS", SF_Pixel)
IMPLEMENT_GLOBAL_SHADER(FTestGroupsCS, "/DrydockTest/Groups.usf", "GroupsCS", SF_Compute);
IMPLEMENT_GLOBAL_SHADER(FTestKeepCS, "/DrydockTest/Counters.usf", "KeepCS", SF_Compute);
IMPLEMENT_GLOBAL_SHADER(FTestTakeCS, "/DrydockTest/Counters.usf", "TakeCS", SF_Compute);
IMPLEMENT_GLOBAL_SHADER(FTestCubeFacesCS, "/DrydockTest/Cubes.usf", "FacesCS", SF_Compute);
IMPLEMENT_GLOBAL_SHADER(FTestCubeSamplesCS, "/DrydockTest/Cubes.usf", "SamplesCS", SF_Compute);
IMPLEMENT_GLOBAL_SHADER(FTestGraphCS, "/DrydockTest/Graph.usf", "GraphCS", SF_Compute);
IMPLEMENT_GLOBAL_SHADER(FTestBrokenCS, "/DrydockTest/Broken.usf", "BrokenCS", SF_Compute);
IMPLEMENT_SHADER_TYPE(, FTestVS, TEXT("/DrydockTest/Vertex.usf"), TEXT("MainVS"), SF_Vertex)

namespace
{

class FTestHiddenCS : public FGlobalShader
{
	DECLARE_GLOBAL_SHADER(FTestHiddenCS)
	SHADER_USE_PARAMETER_STRUCT(FTestHiddenCS, FGlobalShader)

	class FTapsDim : SHADER_PERMUTATION_SPARSE_INT("TAPS", 5, 9, 13);
	using FPermutationDomain = TShaderPermutationDomain<FTapsDim>;

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER(float, Radius)
	END_SHADER_PARAMETER_STRUCT()

	static bool ShouldCompilePermutation(const FGlobalShaderPermutationParameters& Parameters)
	{
		return FPermutationDomain(Parameters.PermutationId).Get<FTapsDim>() != 9;
	}
};

IMPLEMENT_GLOBAL_SHADER(FTestHiddenCS, "/DrydockTest/Nowhere.usf", "MainCS", SF_Compute)

template<bool bTwice>
class TTestTemplatePS : public FGlobalShader
{
	DECLARE_SHADER_TYPE(TTestTemplatePS, Global);

public:
	TTestTemplatePS() = default;
	explicit TTestTemplatePS(const typename ShaderMetaType::CompiledShaderInitializerType& Initializer)
		: FGlobalShader(Initializer)
	{
	}

	static void ModifyCompilationEnvironment(
		const FGlobalShaderPermutationParameters&, FShaderCompilerEnvironment& OutEnvironment)
	{
		OutEnvironment.SetDefine(TEXT("TWICE"), bTwice);
	}
};

IMPLEMENT_SHADER_TYPE(template<>, TTestTemplatePS<true>, TEXT("/DrydockTest/Nowhere.usf"), TEXT("MainPS"), SF_Pixel);
IMPLEMENT_SHADER_TYPE(template<>, TTestTemplatePS<false>, TEXT("/DrydockTest/Nowhere.usf"), TEXT("MainPS"), SF_Pixel);

} // namespace
