// Holds the table of the chain's pass functions, and defines each of them as the way through it.
#include "PassFunctions.h"

#include "Bloom/PostProcessBloomSetup.h"
#include "Bloom/PostProcessFFTBloom.h"
#include "Bloom/PostProcessGaussianBloom.h"
#include "Blur/PostProcessWeightedSampleSum.h"
#include "CodeScope.h"
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
#include <utility>

namespace Drydock
{

namespace
{

/** Never destroyed: libraries may be unloaded later. */
std::vector<FActiveReplacement>& GetRegistered()
{
	static auto* const Registered = new std::vector<FActiveReplacement>;
	return *Registered;
}

std::vector<FActiveReplacement>& GetActive()
{
	static std::vector<FActiveReplacement> Active;
	return Active;
}

std::string FindLibrary(const void* Address)
{
	Dl_info Info = {};
	return dladdr(Address, &Info) != 0 && Info.dli_fname != nullptr ? Info.dli_fname : "";
}

FActiveReplacement* FindActive(const char* Name)
{
	std::vector<FActiveReplacement>& Active = GetActive();
	const auto Found = std::find_if(
		Active.begin(), Active.end(), [Name](const FActiveReplacement& Each) { return Each.Name == Name; });
	return Found != Active.end() ? &*Found : nullptr;
}

} // namespace

const std::vector<FPassFunction>& GetPassFunctions()
{
#define DRYDOCK_MEMBER(Name) #Name,
#define DRYDOCK_PASS_INPUTS(Result, Function, Header, Shader, Effect, Inputs, Members) \
	{#Function, Header, Shader, Effect, #Result, "", #Inputs, {Members}},
#define DRYDOCK_PASS(Result, Scope, Function, Header, Shader, Effect, Parameters, Arguments) \
	{#Scope #Function, Header, Shader, Effect, #Result, #Parameters, "", {}},
	static const std::vector<FPassFunction> Functions = {
#include "PassFunctions.inl"
	};
#undef DRYDOCK_PASS
#undef DRYDOCK_PASS_INPUTS
#undef DRYDOCK_MEMBER
	return Functions;
}

std::string FPassFunction::GetSignature() const
{
	const std::string OfInputs =
		std::string("(FRDGBuilder& GraphBuilder, const FViewInfo& View, const ") + Inputs + "& Inputs)";
	return std::string(Result) + " " + Name + (*Inputs != '\0' ? OfInputs : Parameters);
}

FPassReplacement::FPassReplacement(const char* Name, FAnyFunction InFunction, FAnyFunction Own)
	: Function(InFunction)
{
	// Without a function of its own the library's call leads back to drydock's, and that to the library.
	const std::string Library = FindLibrary(this);
	if (Own != nullptr && FindLibrary(reinterpret_cast<const void*>(Own)) == Library)
	{
		const FCodeOwner Owner = {.Plugin = Library.substr(Library.rfind('/') + 1), .Callback = Name};
		GetRegistered().push_back({Name, Library, InFunction, Owner, false});
	}
}

FPassReplacement::~FPassReplacement()
{
	std::erase_if(GetRegistered(), [this](const FActiveReplacement& Each) { return Each.Address == Function; });
}

FScopedPassReplacements::FScopedPassReplacements(const std::vector<std::string>& Libraries)
	: Before(GetActive())
{
	std::vector<FActiveReplacement> Active;
	for (const std::string& Library : Libraries)
	{
		for (const FActiveReplacement& Each : GetRegistered())
		{
			if (Each.Library == Library)
			{
				std::erase_if(Active, [&](const FActiveReplacement& Lower) { return Lower.Name == Each.Name; });
				Active.push_back(Each);
			}
		}
	}
	GetActive() = std::move(Active);
}

FScopedPassReplacements::~FScopedPassReplacements()
{
	GetActive() = std::move(Before);
}

const FActiveReplacement* TakePassReplacement(const char* Name)
{
	FActiveReplacement* const Found = FindActive(Name);
	if (Found != nullptr)
	{
		Found->bCalled = true;
	}
	return Found;
}

const FActiveReplacement* FindPassReplacement(const char* Name)
{
	return FindActive(Name);
}

std::vector<std::string> TakeUncalledReplacements()
{
	std::vector<std::string> Names;
	for (FActiveReplacement& Each : GetActive())
	{
		if (!std::exchange(Each.bCalled, false))
		{
			Names.push_back(Each.Name);
		}
	}
	return Names;
}

std::vector<std::string> ListPassReplacements(const std::string& Library)
{
	std::vector<std::string> Names;
	for (const FActiveReplacement& Each : GetRegistered())
	{
		if (Each.Library == Library)
		{
			Names.push_back(Each.Name);
		}
	}
	return Names;
}

size_t CountPassReplacements()
{
	return GetRegistered().size();
}

} // namespace Drydock

#define DRYDOCK_MEMBER(Name) &PassInputs.Name,
#define DRYDOCK_PASS_INPUTS(Result, Function, Header, Shader, Effect, Inputs, Members) \
	Result Function(FRDGBuilder& GraphBuilder, const FViewInfo& View, const Inputs& PassInputs) \
	{ \
		if (const Drydock::FActiveReplacement* const Replaced = Drydock::TakePassReplacement(#Function)) \
		{ \
			const void* const Addresses[] = {Members}; \
			using FReplaced = Result (*)(FRDGBuilder&, const FViewInfo&, const void* const*); \
			return Drydock::CallCode(Replaced->Owner, \
				[&] { return reinterpret_cast<FReplaced>(Replaced->Address)(GraphBuilder, View, Addresses); }); \
		} \
		return Drydock::BuiltIn##Function(GraphBuilder, View, PassInputs); \
	}
#define DRYDOCK_PASS(Result, Scope, Function, Header, Shader, Effect, Parameters, Arguments) \
	Result Scope Function Parameters \
	{ \
		if (const Drydock::FActiveReplacement* const Replaced = Drydock::TakePassReplacement(#Scope #Function)) \
		{ \
			using FReplaced = Result(*) Parameters; \
			return Drydock::CallCode( \
				Replaced->Owner, [&] { return reinterpret_cast<FReplaced>(Replaced->Address) Arguments; }); \
		} \
		return Drydock::BuiltIn##Function Arguments; \
	}
#include "PassFunctions.inl"
#undef DRYDOCK_PASS
#undef DRYDOCK_PASS_INPUTS
#undef DRYDOCK_MEMBER
