// Holds the table of the chain's pass functions, and defines each of them as the way through it.
#include "PassFunctions.h"

#include "Bloom/PostProcessBloomSetup.h"
#include "Bloom/PostProcessFFTBloom.h"
#include "Bloom/PostProcessGaussianBloom.h"
#include "Blur/PostProcessWeightedSampleSum.h"
#include "Exposure/PostProcessEyeAdaptation.h"
#include "Exposure/PostProcessHistogram.h"
#include "Exposure/PostProcessLocalExposure.h"
#include "Lens/DiaphragmDOF.h"
#include "Lens/PostProcessMotionBlur.h"
#include "Lens/REDPostProcess.h"
#include "Screen/PostProcessAA.h"
#include "Screen/PostProcessDownsample.h"
#include "Screen/PostProcessUpscale.h"
#include "Tonemap/PostProcessCombineLUTs.h"
#include "Tonemap/PostProcessTonemap.h"

#include <dlfcn.h>

#include <algorithm>

namespace Drydock
{

namespace
{

struct FRegisteredReplacement
{
	std::string Name;
	std::string Library;
	FAnyFunction Function = nullptr;
};

using FActiveReplacements = std::vector<std::pair<std::string, FAnyFunction>>;

/** Never destroyed: libraries may be unloaded later. */
std::vector<FRegisteredReplacement>& GetRegistered()
{
	static auto* const Registered = new std::vector<FRegisteredReplacement>;
	return *Registered;
}

FActiveReplacements& GetActive()
{
	static FActiveReplacements Active;
	return Active;
}

std::string FindLibrary(FAnyFunction Function)
{
	Dl_info Info = {};
	const bool bFound = dladdr(reinterpret_cast<void*>(Function), &Info) != 0;
	return bFound && Info.dli_fname != nullptr ? Info.dli_fname : "";
}

} // namespace

const std::vector<FPassFunction>& GetPassFunctions()
{
#define DRYDOCK_MEMBER(Name) #Name,
#define DRYDOCK_PASS_INPUTS(Result, Function, Header, Shader, Inputs, Members) \
	{#Function, Header, Shader, #Result, "", #Inputs, {Members}},
#define DRYDOCK_PASS(Result, Scope, Function, Header, Shader, Parameters, Arguments) \
	{#Scope #Function, Header, Shader, #Result, #Parameters, "", {}},
	static const std::vector<FPassFunction> Functions = {
#include "PassFunctions.inl"
	};
#undef DRYDOCK_PASS
#undef DRYDOCK_PASS_INPUTS
#undef DRYDOCK_MEMBER
	return Functions;
}

FPassReplacement::FPassReplacement(const char* Name, FAnyFunction InFunction)
	: Function(InFunction)
{
	GetRegistered().push_back({Name, FindLibrary(InFunction), InFunction});
}

FPassReplacement::~FPassReplacement()
{
	std::erase_if(GetRegistered(), [this](const FRegisteredReplacement& Each) { return Each.Function == Function; });
}

FScopedPassReplacements::FScopedPassReplacements(const std::vector<std::string>& Libraries)
	: Before(GetActive())
{
	FActiveReplacements Active;
	for (const std::string& Library : Libraries)
	{
		for (const FRegisteredReplacement& Each : GetRegistered())
		{
			if (Each.Library == Library)
			{
				std::erase_if(Active, [&](const auto& Lower) { return Lower.first == Each.Name; });
				Active.emplace_back(Each.Name, Each.Function);
			}
		}
	}
	GetActive() = std::move(Active);
}

FScopedPassReplacements::~FScopedPassReplacements()
{
	GetActive() = std::move(Before);
}

FAnyFunction FindPassReplacement(const char* Name)
{
	const FActiveReplacements& Active = GetActive();
	const auto Found =
		std::find_if(Active.begin(), Active.end(), [Name](const auto& Each) { return Each.first == Name; });
	return Found != Active.end() ? Found->second : nullptr;
}

size_t CountPassReplacements()
{
	return GetRegistered().size();
}

} // namespace Drydock

#define DRYDOCK_MEMBER(Name) &PassInputs.Name,
#define DRYDOCK_PASS_INPUTS(Result, Function, Header, Shader, Inputs, Members) \
	Result Function(FRDGBuilder& GraphBuilder, const FViewInfo& View, const Inputs& PassInputs) \
	{ \
		if (const Drydock::FAnyFunction Replaced = Drydock::FindPassReplacement(#Function)) \
		{ \
			const void* const Addresses[] = {Members}; \
			using FReplaced = Result (*)(FRDGBuilder&, const FViewInfo&, const void* const*); \
			return reinterpret_cast<FReplaced>(Replaced)(GraphBuilder, View, Addresses); \
		} \
		return Drydock::BuiltIn##Function(GraphBuilder, View, PassInputs); \
	}
#define DRYDOCK_PASS(Result, Scope, Function, Header, Shader, Parameters, Arguments) \
	Result Scope Function Parameters \
	{ \
		if (const Drydock::FAnyFunction Replaced = Drydock::FindPassReplacement(#Scope #Function)) \
		{ \
			using FReplaced = Result(*) Parameters; \
			return reinterpret_cast<FReplaced>(Replaced) Arguments; \
		} \
		return Drydock::BuiltIn##Function Arguments; \
	}
#include "PassFunctions.inl"
#undef DRYDOCK_PASS
#undef DRYDOCK_PASS_INPUTS
#undef DRYDOCK_MEMBER
