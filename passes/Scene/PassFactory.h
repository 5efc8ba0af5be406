// Passes by name: what `"passes": [{"type": "GaussianBlur", "at": "MotionBlur", ...}]` in a config can insert into the
// chain without a line of C++. A pass registers a factory for as long as its library is loaded.
#pragma once

#include "FactoryParameters.h"
#include "RunningCode.h"
#include "SceneRendering.h"
#include "ScreenPass.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace Drydock
{

/** The input that is the picture at the hook, unless the config names another. */
inline constexpr const char* PictureResource = "SceneColor";

struct FPassInputSpec
{
	std::string Name;
	std::string Default; // resource it is without being given; empty: it must be given
	std::string Doc;
};

/** The arguments from which a factory adds a pass. */
struct FPassArguments
{
	std::map<std::string, FScreenPassTexture> Inputs; // every one of the specs, valid
	FParameterValues Values;

	const FScreenPassTexture& GetInput(const std::string& Name) const
	{
		const auto Found = Inputs.find(Name);
		checkf(Found != Inputs.end(), TEXT("There is no input %s"), Name.c_str());
		return Found->second;
	}
};

struct FPassFactory
{
	std::string Type;
	std::string Doc; // one sentence
	std::vector<FPassInputSpec> Inputs = {};
	std::vector<FParameterSpec> Parameters = {};
	/** Adds the pass and returns its output, a texture of any size with its rect. */
	std::function<FScreenPassTexture(FRDGBuilder&, const FViewInfo&, const FPassArguments&)> Add = {};
	FCodeOwner Owner = {}; // of the function; set by registering
};

/** A second one of the same type is refused with a warning in the log; the first stays. False then. */
DRYDOCK_API bool RegisterPassFactory(FPassFactory Factory);
DRYDOCK_API void UnregisterPassFactory(const std::string& Type);

/** The case of letters does not matter where only it differs. Null when there is none. */
DRYDOCK_API const FPassFactory* FindPassFactory(const std::string& Type);

/** All, by type. Valid until one is registered or unregistered. */
DRYDOCK_API std::vector<const FPassFactory*> GetPassFactories();

class FPassFactoryRegistration : private FNoncopyable
{
public:
	explicit FPassFactoryRegistration(const FPassFactory& Factory)
		: Type(RegisterPassFactory(Factory) ? Factory.Type : std::string())
	{
	}
	~FPassFactoryRegistration() { UnregisterPassFactory(Type); }

private:
	std::string Type; // empty: refused
};

} // namespace Drydock
