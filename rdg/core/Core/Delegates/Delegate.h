// Delegates: a callable that is bound later, by object and method, lambda or function, with payload arguments that
// follow the caller's. Source: engine Delegates/Delegate.h, DelegateSignatureImpl.inl, IDelegateInstance.h.
#pragma once

#include "Containers/Array.h"
#include "Delegates/DelegateInstances.h"

template<typename Signature, typename UserPolicy = void>
class TDelegate;
template<typename Signature, typename UserPolicy = void>
class TMulticastDelegate;

/** The part that TDelegate and TMulticastDelegate share: the ways to make a bound delegate. */
template<typename DelegateType, typename ReturnType, typename... ArgumentTypes>
class TDelegateFactory
{
	using FInstance = Drydock::Private::TDelegateInstance<ReturnType, ArgumentTypes...>;

public:
	/** The object must outlive the binding. */
	template<typename ObjectType, typename MethodClass, typename MethodType, typename... PayloadTypes>
	static DelegateType CreateRaw(ObjectType* Object, MethodType MethodClass::*Method, PayloadTypes... Payload)
	{
		return Make(Object, nullptr, BindMethod(Object, Method, std::move(Payload)...));
	}
	template<typename FunctorType, typename... PayloadTypes>
	static DelegateType CreateLambda(FunctorType&& Functor, PayloadTypes... Payload)
	{
		return Make(nullptr, nullptr, BindFunctor(std::forward<FunctorType>(Functor), std::move(Payload)...));
	}
	template<typename FunctionType, typename... PayloadTypes>
	static DelegateType CreateStatic(FunctionType* Function, PayloadTypes... Payload)
	{
		return Make(nullptr, nullptr, BindFunctor(Function, std::move(Payload)...));
	}
	/** Bound as long as the object has an owner. */
	template<typename ObjectType, ESPMode Mode, typename MethodClass, typename MethodType, typename... PayloadTypes>
	static DelegateType CreateSP(
		const TSharedRef<ObjectType, Mode>& Object, MethodType MethodClass::*Method, PayloadTypes... Payload)
	{
		return Make(
			&Object.Get(), WatchShared(Object.ToStdPtr()), BindMethod(&Object.Get(), Method, std::move(Payload)...));
	}
	template<typename ObjectType, ESPMode Mode, typename MethodClass, typename MethodType, typename... PayloadTypes>
	static DelegateType CreateSP(
		const TSharedPtr<ObjectType, Mode>& Object, MethodType MethodClass::*Method, PayloadTypes... Payload)
	{
		return CreateSP(Object.ToSharedRef(), Method, std::move(Payload)...);
	}
	/** From inside an object that derives from TSharedFromThis. */
	template<typename ObjectType, typename MethodClass, typename MethodType, typename... PayloadTypes>
	static DelegateType CreateSP(ObjectType* Object, MethodType MethodClass::*Method, PayloadTypes... Payload)
	{
		return Make(
			Object, WatchShared(Object->AsShared().ToStdPtr()), BindMethod(Object, Method, std::move(Payload)...));
	}
	template<typename ObjectType, typename FunctorType, typename... PayloadTypes>
	static DelegateType CreateSPLambda(ObjectType* Object, FunctorType&& Functor, PayloadTypes... Payload)
	{
		return Make(Object, WatchShared(Object->AsShared().ToStdPtr()),
			BindFunctor(std::forward<FunctorType>(Functor), std::move(Payload)...));
	}
	/** Bound as long as the UObject lives. */
	template<typename ObjectType, typename MethodClass, typename MethodType, typename... PayloadTypes>
	static DelegateType CreateUObject(ObjectType* Object, MethodType MethodClass::*Method, PayloadTypes... Payload)
	{
		return Make(Object, Drydock::Private::WatchObject(Object), BindMethod(Object, Method, std::move(Payload)...));
	}
	template<typename ObjectType, typename FunctorType, typename... PayloadTypes>
	static DelegateType CreateWeakLambda(ObjectType* Object, FunctorType&& Functor, PayloadTypes... Payload)
	{
		return Make(Object, Drydock::Private::WatchObject(Object),
			BindFunctor(std::forward<FunctorType>(Functor), std::move(Payload)...));
	}

private:
	static DelegateType Make(
		const void* Object, Drydock::Private::FLifeWatch Watch, TUniqueFunction<ReturnType(ArgumentTypes...)>&& Call)
	{
		DelegateType Delegate;
		Delegate.Instance = std::make_shared<FInstance>(Object, std::move(Watch), std::move(Call));
		return Delegate;
	}

	template<typename ObjectType>
	static Drydock::Private::FLifeWatch WatchShared(const std::shared_ptr<ObjectType>& Object)
	{
		return [Weak = std::weak_ptr<ObjectType>(Object)]
		{
			return !Weak.expired();
		};
	}

	template<typename FunctorType, typename... PayloadTypes>
	static auto BindFunctor(FunctorType&& Functor, PayloadTypes&&... Payload)
	{
		return [Functor = std::decay_t<FunctorType>(std::forward<FunctorType>(Functor)),
				   ... Payload = std::decay_t<PayloadTypes>(std::move(Payload))](
				   ArgumentTypes... Arguments) mutable -> ReturnType
		{
			return std::invoke(Functor, std::forward<ArgumentTypes>(Arguments)..., Payload...);
		};
	}

	template<typename ObjectType, typename MethodType, typename... PayloadTypes>
	static auto BindMethod(ObjectType* Object, MethodType Method, PayloadTypes&&... Payload)
	{
		return [Object, Method, ... Payload = std::decay_t<PayloadTypes>(std::move(Payload))](
				   ArgumentTypes... Arguments) mutable -> ReturnType
		{
			return std::invoke(Method, *Object, std::forward<ArgumentTypes>(Arguments)..., Payload...);
		};
	}
};

/** At most one binding. Copies share it. */
template<typename ReturnType, typename... ArgumentTypes, typename UserPolicy>
class TDelegate<ReturnType(ArgumentTypes...), UserPolicy>
	: public TDelegateFactory<TDelegate<ReturnType(ArgumentTypes...), UserPolicy>, ReturnType, ArgumentTypes...>
{
	friend class TDelegateFactory<TDelegate, ReturnType, ArgumentTypes...>;

public:
	using RetValType = ReturnType;

	TDelegate() = default;
	TDelegate(std::nullptr_t) {}

	template<typename... BindTypes>
	void BindRaw(BindTypes&&... Arguments)
	{
		*this = TDelegate::CreateRaw(std::forward<BindTypes>(Arguments)...);
	}
	template<typename... BindTypes>
	void BindLambda(BindTypes&&... Arguments)
	{
		*this = TDelegate::CreateLambda(std::forward<BindTypes>(Arguments)...);
	}
	template<typename... BindTypes>
	void BindStatic(BindTypes&&... Arguments)
	{
		*this = TDelegate::CreateStatic(std::forward<BindTypes>(Arguments)...);
	}
	template<typename... BindTypes>
	void BindSP(BindTypes&&... Arguments)
	{
		*this = TDelegate::CreateSP(std::forward<BindTypes>(Arguments)...);
	}
	template<typename... BindTypes>
	void BindUObject(BindTypes&&... Arguments)
	{
		*this = TDelegate::CreateUObject(std::forward<BindTypes>(Arguments)...);
	}
	template<typename... BindTypes>
	void BindWeakLambda(BindTypes&&... Arguments)
	{
		*this = TDelegate::CreateWeakLambda(std::forward<BindTypes>(Arguments)...);
	}

	/** False also when the object of a weak binding is gone. */
	bool IsBound() const { return Instance != nullptr && Instance->IsAlive(); }
	bool IsBoundToObject(const void* Object) const { return IsBound() && Instance->GetObject() == Object; }
	void Unbind() { Instance.reset(); }
	FDelegateHandle GetHandle() const { return Instance != nullptr ? Instance->GetHandle() : FDelegateHandle(); }

	/** Must be bound. */
	ReturnType Execute(ArgumentTypes... Arguments) const
	{
		checkf(IsBound(), "Executing an unbound delegate");
		// The call may rebind this delegate; the binding it runs in must live on.
		const auto Kept = Instance;
		return Kept->Execute(std::forward<ArgumentTypes>(Arguments)...);
	}
	/** Whether it was bound, and so ran. */
	bool ExecuteIfBound(ArgumentTypes... Arguments) const
	{
		const bool bBound = IsBound();
		if (bBound)
		{
			Execute(std::forward<ArgumentTypes>(Arguments)...);
		}
		return bBound;
	}

private:
	std::shared_ptr<Drydock::Private::TDelegateInstance<ReturnType, ArgumentTypes...>> Instance;
};

/** Any number of bindings. Broadcast runs the last one added first, as the engine does; those added meanwhile wait for
 *  the next broadcast. */
template<typename... ArgumentTypes, typename UserPolicy>
class TMulticastDelegate<void(ArgumentTypes...), UserPolicy>
{
public:
	using FDelegate = TDelegate<void(ArgumentTypes...), UserPolicy>;

	FDelegateHandle Add(FDelegate Delegate)
	{
		const FDelegateHandle Handle = Delegate.GetHandle();
		if (Delegate.IsBound())
		{
			Delegates.Add(std::move(Delegate));
		}
		return Handle;
	}
	template<typename... BindTypes>
	FDelegateHandle AddRaw(BindTypes&&... Arguments)
	{
		return Add(FDelegate::CreateRaw(std::forward<BindTypes>(Arguments)...));
	}
	template<typename... BindTypes>
	FDelegateHandle AddLambda(BindTypes&&... Arguments)
	{
		return Add(FDelegate::CreateLambda(std::forward<BindTypes>(Arguments)...));
	}
	template<typename... BindTypes>
	FDelegateHandle AddStatic(BindTypes&&... Arguments)
	{
		return Add(FDelegate::CreateStatic(std::forward<BindTypes>(Arguments)...));
	}
	template<typename... BindTypes>
	FDelegateHandle AddSP(BindTypes&&... Arguments)
	{
		return Add(FDelegate::CreateSP(std::forward<BindTypes>(Arguments)...));
	}
	template<typename... BindTypes>
	FDelegateHandle AddUObject(BindTypes&&... Arguments)
	{
		return Add(FDelegate::CreateUObject(std::forward<BindTypes>(Arguments)...));
	}
	template<typename... BindTypes>
	FDelegateHandle AddWeakLambda(BindTypes&&... Arguments)
	{
		return Add(FDelegate::CreateWeakLambda(std::forward<BindTypes>(Arguments)...));
	}

	/** Whether there was a binding with that handle. */
	bool Remove(FDelegateHandle Handle)
	{
		return Handle.IsValid() &&
			   Delegates.RemoveAll([Handle](const FDelegate& Delegate) { return Delegate.GetHandle() == Handle; }) > 0;
	}
	/** Number of bindings to that object removed. */
	int32 RemoveAll(const void* Object)
	{
		return Delegates.RemoveAll([Object](const FDelegate& Delegate) { return Delegate.IsBoundToObject(Object); });
	}
	void Clear() { Delegates.Empty(); }
	bool IsBound() const
	{
		return Delegates.ContainsByPredicate([](const FDelegate& Delegate) { return Delegate.IsBound(); });
	}
	bool IsBoundToObject(const void* Object) const
	{
		return Delegates.ContainsByPredicate(
			[Object](const FDelegate& Delegate) { return Delegate.IsBoundToObject(Object); });
	}

	void Broadcast(ArgumentTypes... Arguments) const
	{
		// A copy: callees may add and remove. Arguments go to several callees, so none may consume them.
		const TArray<FDelegate> Current = Delegates;
		for (int32 Index = Current.Num() - 1; Index >= 0; --Index)
		{
			Current[Index].ExecuteIfBound(Arguments...);
		}
	}

private:
	TArray<FDelegate> Delegates;
};

#include "Delegates/DelegateCombinations.h"
