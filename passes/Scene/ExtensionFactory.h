// Makes view extensions by name, for `"extensions": [{"type": "Tint", "pass": "Tonemap", ...}]` in a config. A type
// registers a factory for as long as its library is loaded:
//
//     const Drydock::FExtensionFactoryRegistration GTint({
//         .Type = "Tint",
//         .Doc = "Multiplies the picture by a colour.",
//         .Passes = {"Tonemap", "MotionBlur"},
//         .Parameters = {FParameterSpec::Color("Color", FLinearColor(1, 0.5f, 0.25f), "Factor of each channel.")},
//         .Create = [](const FExtensionArguments& Arguments) { return FSceneViewExtensions::NewExtension<FTint>(...);
//         },
//     });
#pragma once

#include "FactoryParameters.h"
#include "RunningCode.h"
#include "SceneViewExtension.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

/** Name of the hook that runs before the chain, beside those of EPostProcessingPass. */
inline constexpr const char* PrePostProcessPassName = "PrePostProcessPass";

/** The arguments from which a factory makes an extension. */
struct FExtensionArguments
{
	/** A name of FExtensionFactory::Passes. */
	std::string Pass;
	FParameterValues Values;
};

struct FExtensionFactory
{
	std::string Type;
	std::string Doc; // one sentence
	/** Hooks it can be given to as "pass", the first one by default: names of EPostProcessingPass and
	 *  PrePostProcessPassName. Empty: it chooses its own, and "pass" is an error. */
	std::vector<std::string> Passes = {};
	std::vector<FParameterSpec> Parameters = {};
	std::function<TSharedRef<ISceneViewExtension, ESPMode::ThreadSafe>(const FExtensionArguments&)> Create = {};
	FCodeOwner Owner = {}; // of the function; set by registering
};

/** A second one of the same type is refused with a warning in the log; the first stays. False then. */
DRYDOCK_API bool RegisterExtensionFactory(FExtensionFactory Factory);
DRYDOCK_API void UnregisterExtensionFactory(const std::string& Type);

/** Null when there is none. */
DRYDOCK_API const FExtensionFactory* FindExtensionFactory(const std::string& Type);

/** All, by type. Valid until one is registered or unregistered. */
DRYDOCK_API std::vector<const FExtensionFactory*> GetExtensionFactories();

class FExtensionFactoryRegistration : private FNoncopyable
{
public:
	explicit FExtensionFactoryRegistration(const FExtensionFactory& Factory)
		: Type(RegisterExtensionFactory(Factory) ? Factory.Type : std::string())
	{
	}
	~FExtensionFactoryRegistration() { UnregisterExtensionFactory(Type); }

private:
	std::string Type; // empty: refused
};

/** "MotionBlur", ...; MAX has none. */
DRYDOCK_API const char* GetPassName(ISceneViewExtension::EPostProcessingPass Pass);

/** Empty when there is no pass of that name (PrePostProcessPass is not one). */
DRYDOCK_API std::optional<ISceneViewExtension::EPostProcessingPass> FindPassByName(const std::string& Name);

/** Names of all passes, in the order of a frame. */
DRYDOCK_API std::vector<std::string> GetPassNames();

} // namespace Drydock
