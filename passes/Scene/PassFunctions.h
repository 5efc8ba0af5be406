// The table of the chain's pass functions. Each function of the engine's name goes through it: to drydock's own passes,
// or to those of an engine overlay that is active.
#pragma once

#include "CoreMinimal.h"
#include "RenderGraphFwd.h"
#include "RunningCode.h"
#include "SceneTextureParameters.h"
#include "ScreenPass.h"

#include <string>
#include <vector>

class FEyeAdaptationParameters;
class FRDGBuilder;
class FTextureDownsampleChain;
class FViewInfo;
struct FBloomSetupInputs;
struct FDownsamplePassInputs;
struct FEyeAdaptationInputs;
struct FFFTBloomInputs;
struct FFFTBloomOutput;
struct FFXAAInputs;
struct FGaussianBlurInputs;
struct FMotionBlurInputs;
struct FTonemapInputs;
struct FUpscaleInputs;

namespace DiaphragmDOF
{
struct FBokehModel;
struct FPhysicalCocModel;
} // namespace DiaphragmDOF

namespace Drydock
{

struct FREDPostProcessParameters;

// drydock's own passes: BuiltInAddBloomSetupPass, ...
#define DRYDOCK_PASS_INPUTS(Result, Function, Header, Shader, Effect, Inputs, Members) \
	Result BuiltIn##Function(FRDGBuilder& GraphBuilder, const FViewInfo& View, const Inputs& PassInputs);
#define DRYDOCK_PASS(Result, Scope, Function, Header, Shader, Effect, Parameters, Arguments) \
	Result BuiltIn##Function Parameters;
#include "PassFunctions.inl"
#undef DRYDOCK_PASS
#undef DRYDOCK_PASS_INPUTS

/** A row of the table, as the code of an overlay is written from it. */
struct FPassFunction
{
	const char* Name = "";       // "AddBloomSetupPass", "DiaphragmDOF::AddPasses"
	const char* Header = "";     // below Renderer/Private
	const char* Shader = "";     // in /Engine/Private; empty: none
	const char* Effect = "";     // that adds it, in the ledger
	const char* Result = "";     // the type
	const char* Parameters = ""; // with parentheses; empty where there are members
	const char* Inputs = "";     // the struct whose members are handed over one by one; empty: none
	std::vector<const char*> Members;

	/** As it is declared. */
	DRYDOCK_API std::string GetSignature() const;
};

DRYDOCK_API const std::vector<FPassFunction>& GetPassFunctions();

using FAnyFunction = void (*)();

/** Puts a function of an overlay's library in the place of a pass function, or of a place of the chain
 * (ChainPlaces.h), while the library is loaded and the overlay is active. Function: of the row's signature; where the
 * row has members, it takes the graph builder, the view and a pointer to the members' addresses. Own: the function that
 * the library must define for that; null, or of another library: nothing is replaced. */
class DRYDOCK_API FPassReplacement : private FNoncopyable
{
public:
	FPassReplacement(const char* Name, FAnyFunction Function, FAnyFunction Own);
	~FPassReplacement();

private:
	FAnyFunction Function;
};

struct FActiveReplacement
{
	std::string Name;
	std::string Library;
	FAnyFunction Address = nullptr;
	FCodeOwner Owner; // for CallCode
	bool bCalled = false;
};

/** While it lives, the replacements of these libraries (paths) act. The last one made wins; it must be destroyed first.
 */
class DRYDOCK_API FScopedPassReplacements : private FNoncopyable
{
public:
	explicit FScopedPassReplacements(const std::vector<std::string>& Libraries);
	~FScopedPassReplacements();

private:
	std::vector<FActiveReplacement> Before;
};

/** The active replacement of that name for one who calls it; null: drydock's own runs. */
DRYDOCK_API const FActiveReplacement* TakePassReplacement(const char* Name);

/** The same for one who only asks. */
DRYDOCK_API const FActiveReplacement* FindPassReplacement(const char* Name);

/** Names of the active replacements that nobody has called since the last call of this. */
DRYDOCK_API std::vector<std::string> TakeUncalledReplacements();

/** Names that a library (path) has registered. */
DRYDOCK_API std::vector<std::string> ListPassReplacements(const std::string& Library);

/** How many are registered, by all libraries that are loaded. */
DRYDOCK_API size_t CountPassReplacements();

} // namespace Drydock
