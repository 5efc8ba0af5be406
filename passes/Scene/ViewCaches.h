// Holds what frames of a view hand on to save time, without a change to any picture: one object of each type that
// passes ask for, held by FSceneViewState.
#pragma once

#include <map>
#include <memory>
#include <typeindex>

namespace Drydock
{

class FViewCaches
{
public:
	/** The object of this type, default-constructed if there is none; it stays where it is as long as frames ask for
	 * it. The frame in progress has used it then. */
	template<typename T>
	T& FindOrMake()
	{
		FCache& Cache = Caches[typeid(T)];
		if (Cache.Object == nullptr)
		{
			Cache.Object = std::make_shared<T>();
		}
		Cache.bUsed = true;
		return *static_cast<T*>(Cache.Object.get());
	}

	void BeginFrame()
	{
		for (auto& [Type, Cache] : Caches)
		{
			Cache.bUsed = false;
		}
	}

	/** Lets go of what the frame did not use. True: there is something left. */
	bool EndFrame()
	{
		std::erase_if(Caches, [](const auto& Entry) { return !Entry.second.bUsed; });
		return !Caches.empty();
	}

private:
	struct FCache
	{
		std::shared_ptr<void> Object;
		bool bUsed = false;
	};

	std::map<std::type_index, FCache> Caches;
};

} // namespace Drydock
